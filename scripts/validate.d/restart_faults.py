"""Section of docs/validation/restart.md: operations of the disk that fail."""
import shutil
import subprocess
import tempfile

from program import DONE, FILE_ERROR, PROGRAM, TENSION, ProgramTest, faulty_disk, settings
from validation import table

CASE = [TENSION, "--quiet", *settings(output__every=1, checkpoint__every=5, output__fields_every=10)]
FOR_EVER = 10**9
# A whole run with its checkpoints takes some 3000 kB.
DISK_SIZES = (20, 60, 100, 400, 800, 1200, 1600, 2000, 2400, 2800, 3200, 3600)
KINDS = {"one operation": lambda number: number, "20 in a row": lambda number: number + 19,
         "all from there on": lambda number: FOR_EVER}


def mount(folder, kilobytes):
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={kilobytes}k", "tmpfs", folder], check=True, capture_output=True)


def can_mount():
    """It takes root, and a system that lets it."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            mount(folder, 100)
        except (subprocess.CalledProcessError, FileNotFoundError):
            return False
        subprocess.run(["umount", folder], check=True)
    return True


class Faults(ProgramTest):
    def whole(self):
        self.call("run", *CASE, "--output", "whole")

    def run_with_failures(self, first, last):
        """The exit code and what was said of it, and whether the run is whole in the end; None if it met no fault."""
        process = self.start("run", *CASE, "--output", "run", **faulty_disk(fail=f"{first}-{last}"))
        _, err = process.communicate()
        try:
            self.assertIn(process.returncode, (DONE, FILE_ERROR))
            if process.returncode == FILE_ERROR:
                self.assertIn("No space left on device", err)
            if (self.folder / "run").exists():
                if process.returncode == FILE_ERROR:
                    self.call("resume", "run", "--quiet")
                self.assertEqual(self.final_hash("run"), self.final_hash("whole"))
                self.assert_same_results("run", "whole")
                self.assertEqual(self.unfinished(), [])
        finally:
            shutil.rmtree(self.folder / "run", ignore_errors=True)
        return process.returncode, err

    def run_on_disk_of(self, kilobytes):
        """The same on a real disk of this size, which grows before the run is resumed."""
        disk = self.folder / "disk"
        disk.mkdir(exist_ok=True)
        mount(disk, kilobytes)
        try:
            process = subprocess.run([PROGRAM, "run", *map(str, CASE), "--output", "run"], cwd=disk, capture_output=True,
                                     text=True, check=False)
            self.assertIn(process.returncode, (DONE, FILE_ERROR))
            subprocess.run(["mount", "-o", "remount,size=64m", disk], check=True)
            if (disk / "run").exists():
                subprocess.run([PROGRAM, "resume", "run", "--quiet"], cwd=disk, check=True)
                self.assertEqual(self.final_hash("disk/run"), self.final_hash("whole"))
                self.assert_same_results("disk/run", "whole")
                self.assertEqual(self.unfinished(), [])
            return process.returncode, process.stderr
        finally:
            subprocess.run(["umount", disk], check=True)


def full_disk_lines(faults, verdicts):
    if not can_mount():
        return ["Real disks that are full were not tried: they could not be mounted.", ""]
    counts = {DONE: 0, FILE_ERROR: 0, "refused": 0}
    failures = []
    for kilobytes in DISK_SIZES:
        try:
            code, err = faults.run_on_disk_of(kilobytes)
            counts["refused" if "resume" not in err and code == FILE_ERROR else code] += 1
        except (AssertionError, subprocess.CalledProcessError) as error:
            failures.append(f"{kilobytes} kB: {str(error).splitlines()[0]}")
    verdict = verdicts.of(not failures, f"full disks: {'; '.join(failures[:3])}")
    text = (f"The same run on {len(DISK_SIZES)} real disks (tmpfs) of {DISK_SIZES[0]} to {DISK_SIZES[-1]} kB: "
            f"{counts['refused']} had no room for its beginning, on {counts[FILE_ERROR]} it ended by exit 5, on "
            f"{counts[DONE]} it came to its end. The disk then grew, and the run was resumed; same bytes: {verdict}.")
    print(text, flush=True)
    return [text, ""]


def faults_section(last_operation, verdicts):
    faults = Faults()
    faults.setUp()
    faults.whole()
    rows = []
    for kind, last_of in KINDS.items():
        step = 1 if kind == "one operation" else 7
        counts = {"all": 0, DONE: 0, FILE_ERROR: 0, "warned": 0}
        failures = []
        n_quiet = 0
        number = 1
        while number <= last_operation and n_quiet < 30:
            try:
                code, err = faults.run_with_failures(number, last_of(number))
            except AssertionError as error:
                failures.append(f"operation {number}: {str(error).splitlines()[0]}")
                code, err = FILE_ERROR, "failed"
            counts["all"] += 1
            counts[code] += 1
            counts["warned"] += "warning" in err
            # Beyond its last operation, a run is quiet.
            n_quiet = n_quiet + step if err == "" else 0
            number += step
        verdict = verdicts.of(not failures, f"{kind} fails: {'; '.join(failures[:3])}")
        rows.append([kind, str(counts["all"]), str(counts["warned"]), str(counts[DONE]), str(counts[FILE_ERROR]), verdict])
        print(*rows[-1], flush=True)
    disks = full_disk_lines(faults, verdicts)
    faults.doCleanups()
    head = ["what fails", "runs", "with warnings", "to their end", "ended by exit 5, and resumed", "same bytes"]
    return ["## Failing disks", "",
            "A small specimen in tension with breaks, an unloading, rows at every step, fields and checkpoints. The operations "
            "that change files (create, write, truncate, flush, rename) are numbered; one of them, twenty in a row, or all "
            "from a number on fail with \"No space left on device\", writes after half of what they were to write. "
            "Target: a run that warns and goes on, or ends by exit 5 and is resumed; in either case the same bytes.", "",
            *table(head, rows), *disks]
