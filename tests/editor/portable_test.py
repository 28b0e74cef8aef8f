#!/usr/bin/env python3
"""What belongs to the user is kept in the folder fumage-data beside the program, if there is one that takes files; else where the system has it.

    portable_test.py <fumage>
"""
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from signals_test import listens, threads

# Not even root writes into the last of them.
CASES = {"no folder": None, "a folder": lambda data: data.mkdir(), "a folder that takes nothing": lambda data: data.symlink_to("/proc/self")}


def recovery_of(program, make, folder):
    """Starts the editor of a folder of its own, and ends it.
    @return whether its room for unsaved work is beside it, and whether that is in the user's folder"""
    own = folder / "program"
    own.mkdir()
    shutil.copy(program, own / "fumage")
    data = own / "fumage-data"
    if make is not None:
        make(data)
    user = folder / "user"
    user.mkdir()
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "XDG_RUNTIME_DIR": str(user), "HOME": str(user),
                   "XDG_CONFIG_HOME": str(user / "config"), "XDG_DATA_HOME": str(user / "share")}
    editor = subprocess.Popen([own / "fumage"], env=environment, stderr=subprocess.DEVNULL)
    while not (listens(editor.pid, signal.SIGTERM) and threads(editor.pid) > 4):  # a window has threads of its own
        assert editor.poll() is None, "it ended by itself"
        time.sleep(.05)
    editor.send_signal(signal.SIGTERM)
    editor.wait(60)
    return (data / "fumage/recovery").exists(), (user / "share/fumage/recovery").exists()


def main():
    for name, make in CASES.items():
        with tempfile.TemporaryDirectory() as folder:
            beside, there = recovery_of(sys.argv[1], make, Path(folder))
        wanted = name == "a folder"
        if (beside, there) != (wanted, not wanted):
            sys.exit(f"{name}: unsaved work lies {'' if beside else 'not '}beside it and {'' if there else 'not '}in the user's folder")
    print(f"{len(CASES)} editors keep unsaved work where they should")


if __name__ == "__main__":
    main()
