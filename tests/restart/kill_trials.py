"""Kills runs at random moments, resumes them, and compares what comes out with the undisturbed run."""

import random
import shutil
import signal
import time
from dataclasses import dataclass

import kill_cases
from program import ProgramTest, faulty_disk


@dataclass
class Count:
    kills: int = 0
    inside_writes: int = 0  # of them, with a file or a row half written
    compared: int = 0  # runs that came to their end and were compared


class KillTrials(ProgramTest):
    """The subclass, or the script, says which cases and how often."""

    def options_of(self, name, schedule):
        case, own = kill_cases.write_case(self.folder, name)
        return [case, "--quiet", *own, *schedule]

    def start_or_resume(self, options, delay):
        # A kill may come before there is a run directory; the run is then to be started again.
        disk = faulty_disk(delay_us=delay)
        if (self.folder / "run" / "run.json").exists():
            return self.start("resume", "run", "--quiet", **disk)
        return self.start("run", *options, "--output", "run", **disk)

    def is_torn(self):
        tables = [self.folder / "run" / f"{name}.csv" for name in ("history", "transient", "energy", "cracks")]
        torn_rows = [table for table in tables if table.exists() and not table.read_bytes().endswith(b"\n")]
        return bool(self.unfinished() or torn_rows)

    def kill_and_resume(self, name, schedule, n_kills, seed):
        """Kills a run of the case so often; a run that ends in between is compared and begun anew."""
        options = self.options_of(name, schedule)
        begin = time.monotonic()
        whole = self.start("run", *options, "--output", "whole")
        whole.communicate()
        duration = time.monotonic() - begin
        self.assertIn(whole.returncode, kill_cases.ENDINGS)
        moments = random.Random(seed)
        count = Count()
        while count.kills < n_kills:
            # Some of the runs spend most of their time within writes.
            process = self.start_or_resume(options, delay=moments.choice((0, 50, 500)))
            time.sleep(moments.uniform(0, duration / 3))
            process.send_signal(signal.SIGKILL)
            process.communicate()
            if process.returncode == -signal.SIGKILL:
                count.kills += 1
                count.inside_writes += self.is_torn()
                continue
            self.compare(process.returncode, whole.returncode, count)
            shutil.rmtree(self.folder / "run")
        process = self.start_or_resume(options, delay=0)
        process.communicate()
        self.compare(process.returncode, whole.returncode, count)
        return count

    def compare(self, code, expected, count):
        self.assertEqual(code, expected)
        self.assertEqual(self.final_hash("run"), self.final_hash("whole"))
        self.assert_same_results("run", "whole")
        self.assertEqual(self.unfinished(), [])
        count.compared += 1
