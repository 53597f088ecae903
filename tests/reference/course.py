"""Course of the model (spec/pipeline.md): starts, steps, holds, bridges, and the drift."""

import flags
from arithmetic import INT32_MAX, clamp, sat32, truncated_quotient, u32
from effects import FOLLOWING, FOR_A_BLOCK, drift_of
from expressions import Expressions
from network import Network
from thermal import Means, Signals, ThermalStage

NO_SIGNALS = Signals(0, 0, Means(0, 0, 0, (0,) * 5))


class BlockDrift:
    """The drift that stands for a block: effects, expressions and network together."""

    def __init__(self, table):
        self.fraction = table.fraction
        self.effects = [(FOR_A_BLOCK[each.id](each.constants), each.coefficients)
                        for each in table.effects if each.id in FOR_A_BLOCK]
        self.expressions = Expressions(table.program)
        self.expression_coefficients = table.expression_coefficients
        self.network = Network(table.network)
        self.plays = [play for effect, _ in self.effects for play in effect.plays] + self.expressions.plays

    @property
    def needs(self):
        """The needed extension inputs, in the order of their numbers."""
        of_effects = {number for effect, _ in self.effects for number in effect.needs}
        return sorted(of_effects | self.expressions.needs | self.network.needs)

    def reset(self, signals):
        for effect, _ in self.effects:
            effect.reset(signals)
        self.expressions.run(signals, restart=True)
        self.network.reset(signals)

    def step(self, signals):
        """The drift, F 20."""
        drift = sum(drift_of(coefficients, effect.regressors(signals), self.fraction)
                    for effect, coefficients in self.effects)
        drift += drift_of(self.expression_coefficients, self.expressions.run(signals), self.fraction)
        return drift + self.network.drift(signals)

    @property
    def history_known(self):
        return (all(effect.history_known for effect, _ in self.effects)
                and all(play.known for play in self.expressions.plays))

    def forget_history(self):
        for play in self.plays:
            play.forget()


class Course:
    def __init__(self, table):
        self.hold_blocks = table.hold_blocks
        self.accurate_blocks = table.accurate_blocks
        self.settle_blocks = table.settle_blocks
        self.thermal = ThermalStage(table)
        self.block = BlockDrift(table)
        self.following = [FOLLOWING[each.id](each.constants, each.coefficients, table.fraction)
                          for each in table.effects if each.id in FOLLOWING]
        self.coefficients_made = False
        self.to_make = None            # signals that the coefficients are to be made of
        self.started = False
        self.held = self.since_good = 0
        self.clamped_left = 0
        self.settling = table.settle_blocks
        self.flags = 0
        self.passed = self.target = NO_SIGNALS.means
        self.left = 0
        self.drift = self.base = self.of_sample = 0

    def start(self, means):
        signals = self.thermal.reset(means)
        self.block.reset(signals)
        self.passed = means
        self.left = 0
        self.started = True
        self.settling = self.settle_blocks
        self.held = self.since_good = 0
        self._evaluate(signals)
        self._follow(means.rate)

    def stop(self):
        self.started = False

    def take(self, means):
        if self.left > 0:
            self.held = min(self.held + 1, self.hold_blocks + 1)
        limit = min(self.hold_blocks, 2**31 - 2)
        given_up = self.held > self.hold_blocks or self.since_good > limit
        if not self.started or given_up or self.left > limit - self.since_good:
            self.start(means)
        else:
            self.target = means
            self.left += self.since_good + 1
            self.since_good = 0

    def hold(self, blocks):
        self.held = min(self.held + blocks, self.hold_blocks + 1)
        self.since_good = min(self.since_good + blocks, self.hold_blocks + 1)

    def unsettle(self):
        self.settling = u32(self.settle_blocks + self.left + self.since_good)

    def catch_up(self):
        if not self.started or self.left == 0:
            return
        self.settling = max(self.settling - 1, 0)
        before = self.base, self.to_make
        self.passed = self._next_of_bridge()
        self.left -= 1
        way_unknown = self.left == 0 and self.held - self.since_good > self.accurate_blocks
        self._evaluate(self.thermal.step(self.passed), way_unknown)
        if self.left > 0:
            # The text keeps drift and of_sample too: evaluate() does not change them.
            self.base, self.to_make = before
        else:
            self._settle_after_bridge()

    def _next_of_bridge(self):
        if self.left == 1:
            return self.target

        def nearer(passed, target):
            return passed + truncated_quotient(sat32(target - passed), self.left)

        passed, target = self.passed, self.target
        return Means(*map(nearer, passed[:3], target[:3]), tuple(map(nearer, passed.inputs, target.inputs)))

    def _settle_after_bridge(self):
        n = self.held - self.since_good
        unsure = 3 * n if n < self.settle_blocks // 3 else self.settle_blocks
        if n > 0:
            self.settling = max(self.settling, unsure)
        self.held = self.since_good

    def _evaluate(self, signals, way_unknown=False):
        clamps = self.thermal.clamps(signals)
        if clamps or way_unknown:
            self.block.forget_history()
        total = self.block.step(signals)
        self.base = (clamp(total, -2**41, INT32_MAX << 10) << 21) + 2**30
        self.to_make = signals
        self.flags = 0
        if clamps or self.block.expressions.clamped or self.block.network.clamped:
            self.clamped_left = self.settle_blocks + 1
        elif self.clamped_left > 0:
            self.clamped_left -= 1
        if self.clamped_left > 0:
            self.flags |= flags.TEMPERATURE_CLAMPED
        if not self.block.history_known:
            self.flags |= flags.HISTORY_UNKNOWN

    def _follow(self, w):
        if self.to_make is not None:
            for effect in self.following:
                effect.make(self.to_make)
            self.to_make = None
            self.coefficients_made = True
        drift = self.base
        if self.coefficients_made:
            drift += sum(effect.drift(w) for effect in self.following)
        self.drift = sat32(drift >> 31)

    def see(self, rate):
        self._follow(sat32(rate - self.of_sample))
        self.of_sample = self.drift

    def see_none(self):
        if self.to_make is not None:
            self._follow(self.to_make.means.rate)
            self.of_sample = self.drift

    @property
    def status(self):
        status = self.flags
        if self.held > 0:
            status |= flags.DRIFT_HELD
        if self.held > self.accurate_blocks:
            status |= flags.DRIFT_OUTDATED
        if not self.started or self.held > self.hold_blocks:
            status |= flags.DRIFT_GIVEN_UP
        if self.settling > 0:
            status |= flags.THERMAL_SETTLING
        return status
