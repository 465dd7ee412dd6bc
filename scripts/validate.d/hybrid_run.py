"""A run of a case whose processor time and memory are measured apart from those of other runs."""
import os
import subprocess
import time

from validation import LIGAMENT, ROOT, Run


def measured_run(folder, name, overrides=()):
    """Runs config/NAME.toml; the run also has `user` (s) and `memory` (peak resident size, MB)."""
    output = folder / f"{name}-{len(list(folder.iterdir()))}"
    arguments = [word for override in overrides for word in ("--set", override)]
    start = time.perf_counter()
    process = subprocess.Popen([LIGAMENT, "run", str(ROOT / "config" / f"{name}.toml"), "--output", str(output), "--quiet",
                                *arguments], cwd=folder)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    run = Run(output, process.returncode, time.perf_counter() - start, usage.ru_utime + usage.ru_stime)
    run.user = usage.ru_utime
    run.memory = usage.ru_maxrss / 1024.0
    return run
