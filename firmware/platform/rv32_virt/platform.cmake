# A processor to replay on: no lines, no watchdog, nothing to choose.
