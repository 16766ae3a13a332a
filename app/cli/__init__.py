"""The command line `laws`: one file per command. Heavy imports wait until a command needs them."""

import gc
import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # numpy's threads cost start-up, help nothing
gc.disable()  # imports make no garbage; who draws turns it on again

import sys  # noqa: E402

from app.cli import streams  # noqa: E402
from app.cli.stopping import Stopped, wish  # noqa: E402


def main() -> None:
    """Run the command in `sys.argv` and exit with its code; no traceback without `--debug`."""
    streams.prepare()
    debug = "--debug" in sys.argv
    try:
        os.getcwd()
    except OSError:
        streams.say("laws: the working folder is gone; change into another")
        sys.exit(2)
    try:
        wish.heed_signals()
        from app.cli import program  # takes time, in which Ctrl-C may come already

        program.with_commands_for(sys.argv[1:])()
    except Stopped as stopped:
        sys.exit(stopped.exit_code)
    except Exception as error:  # noqa: BLE001 - the outermost door: a person gets one sentence
        if debug:
            import traceback

            traceback.print_exc()
        else:
            streams.say(f"laws: {_sentence(error)}")
        sys.exit(2 if isinstance(error, ImportError) else 1)
    finally:
        gc.freeze()  # nothing to look for any more: the process ends


def _sentence(error: Exception) -> str:
    if isinstance(error, streams.ResultLost):
        return str(error)
    if isinstance(error, ImportError):
        return f"the installation is broken: {error}; 'laws doctor' says what to do"
    said = " ".join(str(error).split()) or type(error).__name__
    return f"something went wrong: {said}; run again with --debug for details"
