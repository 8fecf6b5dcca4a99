"""How the reports of the matrix write numbers, names and verdicts."""

WHY_NOT = {"refused": "no", "too_slow": "slow", "crashed": "crash", "left_out": "–"}


def power(count):
    exponent = len(str(count)) - 1
    if count != 10**exponent:
        return f"{count:,}"
    return "10" + str(exponent).translate(str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹"))


def short(contestant):
    return f"`{contestant.removeprefix('abut_')}`"


def label(matrix, scene, count=None):
    count = matrix.main_count(scene) if count is None else count
    return f"{scene}, {power(count)}"


def times(value):
    return "–" if value is None else f"{value:,.2f}×" if value < 9.95 else f"{value:,.0f}×"


def of_possible(speedup, possible):
    """A speedup, and what the processors gave meanwhile where that is known."""
    return times(speedup) if possible is None else f"{times(speedup)} of {times(possible)}"


def yes_or_no(condition):
    return "–" if condition is None else "yes" if condition else "**no**"
