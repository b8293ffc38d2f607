# SPDX-License-Identifier: MIT
"""Entry point of `./run` and `./test`."""

from __future__ import annotations

import signal
import sys
from types import FrameType

from . import cli, testing
from .console import Failure
from .paths import explain


def _interrupt(_number: int, _frame: FrameType | None) -> None:
    raise KeyboardInterrupt


def main() -> int:
    """Runs a command; whatever it starts has ended when this returns."""
    signal.signal(signal.SIGTERM, _interrupt)
    signal.signal(signal.SIGHUP, _interrupt)
    job, arguments = sys.argv[1], sys.argv[2:]
    try:
        return cli.main(arguments) if job == "run" else testing.main(arguments)
    except Failure as failure:
        print(f"\n{failure}", file=sys.stderr)
        return failure.code
    except KeyboardInterrupt:
        print("\nInterrupted.", file=sys.stderr)
        return 130
    except BrokenPipeError:
        return 141
    except OSError as error:
        print(f"\n{explain(error)}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
