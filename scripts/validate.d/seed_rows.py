"""Rows of a table with a column for every assembly, their mean, the target, and whether it is met."""
from validation import mean


def row_of_all(label, values, form, target, met):
    return [label, *(form.format(value) for value in values), form.format(mean(values)), target, met]


def row_within(beam, label, values, paper, tolerance, verdicts):
    """Counts that each assembly must have; the paper's is rounded as it stands there."""
    passed = all(abs(value / paper - 1.0) <= tolerance for value in values)
    form = "{:.0f}" if paper > 10 else "{:.3f}"
    return row_of_all(label, values, form, f"{form.format(paper)} ± {tolerance:.1%}, each",
                      verdicts.of(passed, f"{beam}: {label}"))


def row_below(beam, label, values, limit, form, verdicts):
    return row_of_all(label, values, form, f"≤ {form.format(limit)}, each",
                      verdicts.of(max(values) <= limit, f"{beam}: {label} (largest {form.format(max(values))})"))
