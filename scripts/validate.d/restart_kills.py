"""Section of docs/validation/restart.md: kills at random moments."""
import kill_cases
from kill_trials import Count, KillTrials
from validation import table


def trials_of(name, schedule, n_kills, seed):
    """What came of it, and what went wrong in words; empty if nothing did."""
    trials = KillTrials()
    trials.setUp()
    try:
        return trials.kill_and_resume(name, schedule, n_kills, seed), ""
    except AssertionError as error:
        return Count(), str(error).splitlines()[0]
    finally:
        trials.doCleanups()


def kills_section(n_kills, seed, verdicts):
    names = kill_cases.names()
    rows = []
    total = Count()
    for number, name in enumerate(names):
        share = n_kills * (number + 1) // len(names) - n_kills * number // len(names)
        schedule = kill_cases.SCHEDULES[(number + seed) % len(kill_cases.SCHEDULES)]
        count, failure = trials_of(name, schedule, share, seed * 1000 + number)
        verdict = verdicts.of(not failure, f"kills of {name}: {failure}")
        rows.append([name, str(count.kills), str(count.inside_writes), str(count.compared), verdict])
        print(*rows[-1], flush=True)
        for field in ("kills", "inside_writes", "compared"):
            setattr(total, field, getattr(total, field) + getattr(count, field))
    rows.append(["all", str(total.kills), str(total.inside_writes), str(total.compared), ""])
    head = ["case", "kills", "inside a write", "runs compared at their end", "same bytes"]
    text = ["## Kills", "",
            "`SIGKILL` at random moments, from the start of the process on; the run is resumed and killed again until it "
            "comes to its end, and is then compared. Two thirds of the processes have a disk that is slowed down, and does "
            "each write in two halves, so that many kills fall into a write: they leave a file or a row half written. "
            "Target: the same bytes after each.", ""]
    return text + table(head, rows)
