# A processor for replays: no serial lines, no watchdog, no variants.
