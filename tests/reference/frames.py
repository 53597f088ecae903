"""Output streams (SPEC.md). The image is intact, so all CRCs begin with ones."""

import struct
from typing import NamedTuple

import flags
from arithmetic import crc16, crc32, rate_float, round_shift

KVH, COMPACT, BOTH = range(3)


class Answer(NamedTuple):
    """What a sample is answered with."""
    number: int                # sequence of the sensor sample
    compensated: int
    denoised: int
    drift: int
    temperature: int           # the last good one
    status: int
    angle: int                 # the delta angle as a single; None where the model has not chosen it
    undelayed: bool            # what the KVH frame has


def kvh_frame(answer, frames_before):
    rate, refused = ((answer.compensated, flags.RATE_REFUSED) if answer.undelayed else
                     (answer.denoised, flags.DENOISED_REFUSED))
    rotation = rate_float(rate) if answer.angle is None else answer.angle
    status = 0 if answer.status & refused else 1 << 2
    head = struct.pack(">IIIIIIIBBh", 0xFE81FF55, 0, 0, rotation, 0, 0, 0, status, frames_before % 128,
                       round_shift(answer.temperature, 16))
    return head + struct.pack(">I", crc32(head))


def compact_frame(answer, delay):
    body = struct.pack("<HiiiiIH", answer.number, answer.compensated, answer.denoised, answer.drift,
                       answer.temperature, answer.status, delay)
    return b"\xC3\x3C" + body + struct.pack("<H", crc16(body))
