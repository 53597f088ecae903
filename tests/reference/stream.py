"""Frames in the stream (spec/samples.md; formats in SPEC.md, "Sensor stream")."""

import struct
from typing import NamedTuple

from arithmetic import crc16


class SensorSample(NamedTuple):
    number: int
    counts: int
    temperature: int
    gyro_valid: bool
    temperature_valid: bool


class Record(NamedTuple):
    """An extension record."""
    input: int
    value: int


def sample_of(frame):
    """The sample that these 16 bytes are, or None."""
    number, counts, temperature, status, reserved, crc = struct.unpack("<HiiBBH", frame[2:])
    if reserved != 0 or status > 3 or crc != crc16(frame[2:14]):
        return None
    return SensorSample(number, counts, temperature, bool(status & 1), bool(status & 2))


def record_of(frame):
    """The extension record that these 10 bytes are, or None."""
    which, reserved, value, crc = struct.unpack("<BBiH", frame[2:])
    if reserved != 0 or which > 4 or crc != crc16(frame[1:8]):
        return None
    return Record(which, value)


KINDS = {0x5A: (16, sample_of), 0xC3: (10, record_of)}


class Parser:
    """Bytes in, in pieces of any size; samples and extension records out."""

    def __init__(self):
        self.bytes = b""

    def feed(self, more):
        data = self.bytes + more
        p = 0
        while True:
            p = data.find(0xA5, p)
            if p < 0:
                p = len(data)
            if p + 2 > len(data):
                break
            size, frame_of = KINDS.get(data[p + 1], (0, None))
            if size == 0:
                p += 1
                continue
            if p + size > len(data):
                break
            frame = frame_of(data[p:p + size])
            p += size if frame else 1
            if frame:
                yield frame
        self.bytes = data[p:]
