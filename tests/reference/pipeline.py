"""One sample through all stages (spec/pipeline.md), as a replay does it: no clock, the image intact, no silence."""

import flags
from arithmetic import DeltaAngle, INT32_MAX, round_divide, round_shift, sat32
from course import Course
from denoiser import Denoiser
from effects import T2
from frames import BOTH, COMPACT, KVH, Answer, compact_frame, kvh_frame
from samples import GOOD_ANEW, NONE, Judge, Limits, Reading
from stream import Parser, Record
from thermal import Means

BOARD = 5                              # extension inputs that there are


def mean(values):
    return round_divide(sum(values), len(values))


class NeededInput:
    """An extension input that the model needs: its monitor, and its good values."""

    def __init__(self, number, limits, period):
        self.reading = Reading(limits, number == T2, period)
        self.elapsed = 0               # samples since its last record
        self.pending = []
        self.collected = []            # of the block: the means of each sample

    def take(self, value):
        """The use that the value is of."""
        _, use = self.reading.judge(value, True, self.elapsed)
        self.elapsed = 0
        return use

    def forget(self):
        self.pending = []
        self.collected = []

    def collect(self):
        if self.pending:
            self.collected.append(mean(self.pending))
            self.pending = []


class Pipeline:
    def __init__(self, table):
        self.table = table
        self.judge = Judge(table)
        self.course = Course(table)
        self.denoiser = Denoiser(table.denoiser)
        self.delta_angle = DeltaAngle(table.period) if table.delta_angle else None
        self.inputs = self._needed_inputs()
        self.position = 0
        self.elapsed_blocks = 0
        self.temperatures = []
        self.rates = []
        self.input_missing = False
        self.last_rate = 0
        self.last_temperature = 0
        self.denoised = (0, False)
        self.angle = 0
        self.doubtful_left = 0
        self.frames = 0

    def _needed_inputs(self):
        """By number. Those that the table has no words for accept 0 only."""
        needs = self.course.block.needs
        limits = list(self.table.inputs) + [Limits(0, 0, 0)] * BOARD
        return {number: NeededInput(number, each, self.table.period) for number, each in zip(needs, limits)}

    # Extension record

    def record(self, record):
        needed = self.inputs.get(record.input)
        if needed is None:
            return
        use = needed.take(record.value)
        if use == NONE:
            return
        if use == GOOD_ANEW:
            self.course.stop()
            needed.forget()
        needed.pending.append(record.value)

    # Sample

    def sample(self, sample):
        """The bytes that are sent."""
        rate = sat32(round_shift(sample.counts * self.table.multiplier, self.table.shift))
        verdict = self.judge.judge(sample, rate)
        self._finish(self._advance(verdict.missing))
        if verdict.doubtful:
            self.course.unsettle()
        good = self._start_or_stop(sample, rate, verdict)
        status = self._drift(rate, verdict)
        compensated = sat32(rate - self.course.drift)
        well = not status & flags.BOLD
        if status & self.table.chosen:
            status |= flags.RATE_REFUSED
        if not verdict.late:
            self.frames += verdict.missing
            self._denoise(compensated, well, bool(status & flags.RATE_REFUSED), verdict.missing > 0)
            if good:
                self.last_temperature = sample.temperature
        status = self._denoised_status(status)
        sent = self._send(sample.number, compensated, status, verdict.late)
        if not verdict.late:
            self._blocks(verdict, sample.temperature if good else None, compensated if well else None)
        return sent

    # 2. Start or stop the model.

    def _start_or_stop(self, sample, rate, verdict):
        """Whether the temperature is good."""
        off = verdict.flags & flags.SAMPLE_RATE
        if verdict.use == GOOD_ANEW or off:
            self.course.stop()
            self.temperatures = []
        good = verdict.use != NONE and not off
        if good and not self.course.started and all(needed.pending for needed in self.inputs.values()):
            pending = {number: mean(needed.pending) for number, needed in self.inputs.items()}
            self.course.start(Means(sample.temperature, self.elapsed_blocks, rate, self._all_inputs(pending)))
        return good

    @staticmethod
    def _all_inputs(means):
        return tuple(means.get(number, 0) for number in range(BOARD))

    # 3. Drift of this sample.

    def _drift(self, rate, verdict):
        """The status so far."""
        if verdict.flags & flags.BOLD:
            self.course.see_none()
        else:
            self.course.see(rate)
        status = verdict.flags | self.course.status
        if self.input_missing:
            status |= flags.INPUT_MISSING
        if not (verdict.confirmed and all(needed.reading.confirmed for needed in self.inputs.values())):
            status |= flags.DRIFT_GIVEN_UP
        return status

    # 4. Denoise.

    def _denoise(self, compensated, well, refused, lost):
        self.denoised = self.denoiser.denoise(compensated, well)
        if self.delta_angle:
            self.angle = self.delta_angle.step(compensated if self.table.undelayed else self.denoised[0])
        if well and refused:
            self.doubtful_left = self.denoiser.delay + 1
        elif lost:
            self.doubtful_left = self.denoiser.delay
        elif self.doubtful_left > 0:
            self.doubtful_left -= 1

    def _denoised_status(self, status):
        _, valid = self.denoised
        if not valid or self.doubtful_left > 0:
            status |= flags.DENOISED_INVALID
        if self.denoiser.filling:
            status |= flags.DENOISER_FILLING
        if status & (self.table.chosen | flags.DENOISED_INVALID):
            status |= flags.DENOISED_REFUSED
        return status

    # 5. Send the frames.

    def _send(self, number, compensated, status, late):
        angle = None
        if self.delta_angle:
            angle = 0 if late else self.angle
        answer = Answer(number, compensated, self.denoised[0], self.course.drift, self.last_temperature, status,
                        angle, self.table.undelayed)
        sent = b""
        if self.table.frames in (KVH, BOTH):
            sent += kvh_frame(answer, self.frames)
        if self.table.frames in (COMPACT, BOTH):
            sent += compact_frame(answer, self.denoiser.delay)
        self.frames += 1
        return sent

    # 1 and 6. Blocks.

    def _blocks(self, verdict, temperature, rate):
        for needed in self.inputs.values():
            needed.elapsed = min(needed.elapsed + verdict.missing + 1, 2**31)
        if temperature is not None:
            self.temperatures.append(temperature)
        if rate is not None:
            self.rates.append(rate)
        for needed in self.inputs.values():
            needed.collect()
        self._finish(self._advance(1))
        for _ in range(min(self.table.hold_blocks // self.table.samples_per_block, 63) + 1):
            self.course.catch_up()

    def _advance(self, samples):
        """How many blocks end."""
        self.position += samples
        blocks, self.position = divmod(self.position, self.table.samples_per_block)
        self.elapsed_blocks = min(self.elapsed_blocks + blocks, INT32_MAX)
        return blocks

    def _finish(self, blocks):
        if blocks == 0:
            return
        self.input_missing = not all(needed.collected for needed in self.inputs.values())
        if self.temperatures and not self.input_missing:
            if self.rates:
                self.last_rate = mean(self.rates)
            inputs = {number: mean(needed.collected) for number, needed in self.inputs.items()}
            self.course.take(Means(mean(self.temperatures), self.elapsed_blocks - (blocks - 1), self.last_rate,
                                   self._all_inputs(inputs)))
            blocks -= 1
        self._forget_block()
        if blocks > 0:
            self.course.hold(blocks)

    def _forget_block(self):
        self.temperatures = []
        self.rates = []
        for needed in self.inputs.values():
            needed.collected = []


class Replay:
    """A captured sensor stream in, in pieces of any size; what each sample causes to be sent out."""

    def __init__(self, table):
        self.parser = Parser()
        self.pipeline = Pipeline(table)

    def feed(self, data):
        for frame in self.parser.feed(data):
            if isinstance(frame, Record):
                self.pipeline.record(frame)
            else:
                yield self.pipeline.sample(frame)
