"""The programs that are tried here, in the folder that they were built in."""

import pathlib
import sys


def built_programs(build, *names):
    """Paths of the programs, as texts; ends with what to do where one is not built.

    names: below the build folder, as "bin/fumage".
    """
    paths = [pathlib.Path(build).resolve() / name for name in names]
    missing = [path.name for path in paths if not path.exists()]
    if missing:
        sys.exit(f"{build} has no {' and no '.join(missing)}. Build: cmake --build {build} --target {' '.join(missing)}")
    return [str(path) for path in paths]
