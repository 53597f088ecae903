"""Cost of a sample, in instructions (SPEC.md)."""

from course import BlockDrift
from expressions import COSINE, SHAPES, SINE

INSTRUCTIONS_PER_US = 70


def step_cost(table):
    """Of the drift model."""
    words = sum(1 + SHAPES[operation.code].words for operation in table.program)
    waves = sum(operation.code in (SINE, COSINE) for operation in table.program)
    network = 100 * len(table.network.inputs) + 36 * len(table.network.neurons) if table.network else 0
    return 400 + 800 * len(table.effects) + 100 * words + 100 * waves + network


def keep_cost(table):
    """Of its state, for a restart."""
    return 6800 if table.program else 3400


def sample_cost(table):
    steps = min(table.hold_blocks // table.samples_per_block, 63) + 1
    model, keep = steps * step_cost(table), keep_cost(table)
    block = model + keep if table.samples_per_block == 1 else max(model, keep)
    inputs = 1300 * len(BlockDrift(table).needs)
    return 4600 + inputs + table.denoiser.levels * (180 + 10 * table.denoiser.taps) + block
