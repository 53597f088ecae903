"""Effects that stand for a block, and effects that follow the input rate (spec/effects.md).

Each class says in `constants` which values a reader accepts, in `counts` how many coefficients go with them, and in
`needs` the extension inputs that it needs.
"""

from arithmetic import INT32_MAX, INT32_MIN, clamp, i32, round_shift, sat32, scaled, top, upper
from functions import exponential, logarithm, logistic, sine_cosine
from thermal import Derivative, Lag, Play

ANY = (INT32_MIN, INT32_MAX)
POSITIVE = (1, INT32_MAX)
NOT_NEGATIVE = (0, INT32_MAX)

T2, MAGNETIC, LIGHT, SUPPLY, VIBRATION = range(5)      # extension inputs


def drift_of(coefficients, regressors, fraction):
    """The drift (F 20) of regressors at F 28."""
    return sum(round_shift(c * r, fraction + 8) for c, r in zip(coefficients, regressors))


# Effects that stand for a block

class Effect:
    constants = ()
    needs = ()             # extension inputs
    plays = ()

    def __init__(self, constants):
        self.c = constants

    @staticmethod
    def counts(constants):
        return 1

    @property
    def history_known(self):
        return all(play.known for play in self.plays)

    def reset(self, signals):
        pass

    def regressors(self, signals):
        """Those of the effect's step."""
        raise NotImplementedError


def above_20(signals):
    """t"""
    return signals.trained - (20 << 16)


class Bias(Effect):
    def regressors(self, signals):
        return [2**28]


class BiasTemperature(Effect):
    constants = ((1, 9),)

    @staticmethod
    def counts(constants):
        return constants[0]

    def regressors(self, signals):
        x = scaled(above_20(signals), -6)
        powers = [x]
        while len(powers) < self.c[0]:
            powers.append(scaled(powers[-1] * x, 28))
        return powers


class TemperatureRate(Effect):
    def regressors(self, signals):
        return [scaled(signals.change, -1)]


class ThermalLag(Effect):
    constants = (POSITIVE,)

    def __init__(self, constants):
        super().__init__(constants)
        self.lag = Lag(constants[0])

    def reset(self, signals):
        self.lag.reset(signals.change << 15)

    def regressors(self, signals):
        return [scaled(self.lag.step(signals.change << 15), 14)]


class Shupe(ThermalLag):
    def regressors(self, signals):
        x = signals.change << 15
        return [scaled(x - self.lag.step(x), 15)]


class TemperatureRateProduct(Effect):
    def regressors(self, signals):
        return [scaled(above_20(signals) * signals.change, 22)]


class AxialGradient(Effect):
    constants = (POSITIVE, POSITIVE)
    needs = (T2,)

    def __init__(self, constants):
        super().__init__(constants)
        self.derivative = Derivative(*constants)

    @staticmethod
    def counts(constants):
        return 2

    @staticmethod
    def _difference(signals):
        return sat32(signals.means.inputs[T2] - signals.means.temperature)

    def reset(self, signals):
        self.derivative.reset(self._difference(signals))

    def regressors(self, signals):
        difference = self._difference(signals)
        return [scaled(self.derivative.step(difference), -1), scaled(difference, -7)]


class PolarizationRipple(Effect):
    constants = (POSITIVE, NOT_NEGATIVE, ANY)

    @staticmethod
    def counts(constants):
        return 4 if constants[1] > 0 else 2

    def regressors(self, signals):
        t = above_20(signals)
        share = i32(round_shift(t * self.c[2], 24))
        u = i32((t << 7) + round_shift(t * share, 24))
        found = []
        for inverse in self.c[:2]:
            if inverse > 0:
                sine, cosine = sine_cosine(round_shift(u * inverse, 22))
                found += [round_shift(cosine, 2), round_shift(sine, 2)]
        return found


class ThermalHysteresis(Effect):
    constants = ((1, 2**30 - 1), ANY, (0, 2**30 - 1), ANY)

    def __init__(self, constants):
        super().__init__(constants)
        radius, inverse, radius2, inverse2 = constants
        self.plays = [Play(radius)] + ([Play(radius2)] if radius2 > 0 else [])
        self.inverses = [inverse, inverse2]

    @staticmethod
    def counts(constants):
        return 2 if constants[2] > 0 else 1

    def reset(self, signals):
        for play in self.plays:
            play.reset(signals.trained << 6)

    def regressors(self, signals):
        x = signals.trained << 6
        return [scaled((x - play.step(x)) * inverse, 23) for play, inverse in zip(self.plays, self.inverses)]


class GlassTransition(Effect):
    constants = ((-2**30 + 1, 2**30 - 1), POSITIVE, NOT_NEGATIVE)

    def __init__(self, constants):
        super().__init__(constants)
        self.lag = Lag(constants[2])

    @staticmethod
    def counts(constants):
        return 2

    def glassy(self, signals):
        return logistic(scaled((self.c[0] - (signals.trained << 6)) * self.c[1], 24))

    def reset(self, signals):
        self.lag.reset(self.glassy(signals) << 10)

    def regressors(self, signals):
        s = self.glassy(signals)
        if self.c[2] > 0:
            s = round_shift(self.lag.step(s << 10), 10)
        return [round_shift(s, 2), scaled(s * signals.change, 29)]


class WarmUp(Effect):
    constants = (POSITIVE,)
    history_known = False

    def regressors(self, signals):
        exponent = scaled(signals.means.blocks * self.c[0], 5)
        self.history_known = exponent >= 5 << 26
        return [round_shift(exponential(exponent), 2)]


class Aging(Effect):
    constants = (POSITIVE, NOT_NEGATIVE, POSITIVE)

    def __init__(self, constants):
        super().__init__(constants)
        self.age = self.counted = 0

    def regressors(self, signals):
        below = max((130 << 16) - signals.trained, 0)
        speed = round_shift(exponential(scaled(below * self.c[1], 21)) * self.c[2], 30)
        now = signals.means.blocks
        passed = now if now < self.counted else now - self.counted
        self.age = min(self.age + passed * speed, (2**31 - 1) << 16)
        self.counted = now
        onset = self.c[0] << 7
        return [logarithm(onset + self.age, 16) - logarithm(onset, 16)]


class Magnetic(Effect):
    needs = (MAGNETIC,)

    @staticmethod
    def counts(constants):
        return 2

    def regressors(self, signals):
        field = signals.means.inputs[MAGNETIC]
        return [scaled(field, -4), scaled(field * above_20(signals), 18)]


class Vibration(Effect):
    needs = (VIBRATION,)

    def regressors(self, signals):
        g = signals.means.inputs[VIBRATION]
        return [scaled(g * g, 12)]


class LightPower(Effect):
    needs = (LIGHT,)

    def regressors(self, signals):
        power = signals.means.inputs[LIGHT]
        return [scaled(logarithm(max(power, 1), 16) - logarithm(100 << 16, 16), -1)]


FOR_A_BLOCK = {
    0: Bias, 1: BiasTemperature, 2: TemperatureRate, 3: Shupe, 4: ThermalLag, 5: TemperatureRateProduct,
    6: AxialGradient, 7: PolarizationRipple, 8: ThermalHysteresis, 9: GlassTransition, 11: WarmUp, 12: Aging,
    13: Magnetic, 14: Vibration, 15: LightPower,
}


# Effects that follow the input rate

class Following:
    """`make` makes its coefficients of T'; `drift` (F 41) is that at a rate w."""
    constants = ()
    needs = ()

    def __init__(self, constants, coefficients, fraction):
        self.c = constants
        self.k = [coefficient << (40 - fraction) for coefficient in coefficients]

    @staticmethod
    def counts(constants):
        return 1

    @staticmethod
    def accepts(constants):
        """What the limits of single constants do not say."""
        return True

    def make(self, signals):
        raise NotImplementedError

    def drift(self, w):
        return w * self.e


class ScaleFactor(Following):
    def make(self, signals):
        self.e = clamp(sat32(round_shift(self.k[0], 27)), -2**30, 2**30)


class ScaleFactorTemperature(Following):
    constants = ((1, 3), (-256 << 16, 256 << 16), ANY)

    @staticmethod
    def counts(constants):
        return constants[0]

    def make(self, signals):
        late = round_shift(self.c[2] * signals.change, 30)
        x = clamp(((signals.trained - self.c[1]) << 3) - late, -386 << 19, 386 << 19)
        s = 0
        for k in reversed(self.k):
            s = clamp(round_shift(k, 24) + round_shift(s * x, 25), -2**35, 2**35)
        self.e = clamp(sat32(round_shift(s * x, 29)), -2**29, 2**29)


class ScaleFactorNonlinearity(Following):
    constants = ((2, 5), POSITIVE)

    def __init__(self, constants, coefficients, fraction):
        super().__init__(constants, coefficients, fraction)
        self.full_scale = constants[1]
        self.z = 30 - top(self.full_scale)
        self.inverse = (2**61 - 1) // (self.full_scale << self.z)

    @staticmethod
    def counts(constants):
        return constants[0] - 1

    def make(self, signals):
        e2, e3, e4, e5 = [sat32(round_shift(k, 22)) for k in self.k] + [0] * (4 - len(self.k))
        polynomial = (-24 * e3 + 30 * e5, 24 * e2 - 60 * e4, 40 * e3 - 140 * e5, 70 * e4, 126 * e5)
        self.p = [clamp(sat32(round_shift(p, 5)), -402653184, 402653184) for p in polynomial]

    def drift(self, w):
        v = clamp(w, -self.full_scale, self.full_scale)
        u = ((v << self.z) * self.inverse) >> 30
        s = self.p[4]
        for i in (3, 2, 1, 0):
            s = self.p[i] + 2 * upper(s, u)
        return v * round_shift(s, 4)


class ScaleFactorAsymmetry(Following):
    constants = (POSITIVE, POSITIVE)

    @staticmethod
    def accepts(constants):
        return constants[0] * constants[1] <= 3 * 2**41

    def make(self, signals):
        self.e = clamp(sat32(round_shift(self.k[0], 27)), -2**28, 2**28)

    def drift(self, w):
        dead_band, inverse = self.c
        m = min(abs(w), INT32_MAX)
        if m < dead_band:
            m = round_shift(m * round_shift(m * inverse, 12), 31)
        else:
            m -= round_shift(dead_band, 1)
        return m * self.e


FOLLOWING = {
    10: ScaleFactorTemperature, 17: ScaleFactor, 18: ScaleFactorNonlinearity, 19: ScaleFactorAsymmetry,
}
