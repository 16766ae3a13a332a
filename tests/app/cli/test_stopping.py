import os
import signal
import subprocess
import sys

import pytest
from command_line import PUSH, files, surroundings

from app.cli.stopping import Stopped, Wish

STOPPED_WHILE_IT_LOADS = """
import os, signal, sys

class Impatient:
    def find_spec(self, name, path=None, target=None):
        if name == "typer":
            os.kill(os.getpid(), signal.{number})

sys.meta_path.insert(0, Impatient())
from app.cli import main
sys.argv = ["laws", "list"]
main()
"""


@pytest.fixture
def own_handlers():
    hook = sys.unraisablehook
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    yield
    for number, handler in before.items():
        signal.signal(number, handler)
    sys.unraisablehook = hook


@pytest.mark.parametrize(("number", "code"), [("SIGINT", 130), ("SIGTERM", 143)])
def test_a_signal_while_the_program_loads_says_nothing(number, code):
    done = subprocess.run(
        [sys.executable, "-c", STOPPED_WHILE_IT_LOADS.format(number=number)],
        capture_output=True,
        env=surroundings(),
        timeout=60,
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (code, b"", b"")


@pytest.mark.usefixtures("own_handlers")
def test_a_signal_that_a_callback_swallowed_is_raised_again():
    wish = Wish()
    wish.heed_signals()
    wish.insist()
    with pytest.raises(Stopped):
        os.kill(os.getpid(), signal.SIGTERM)
    with pytest.raises(Stopped) as stopped:
        wish.insist()
    assert stopped.value.exit_code == 143


def test_a_run_asks_at_every_tick(tmp_path):
    """Signals may come in a destructor, which swallows what is raised, and Python would say so."""
    (tmp_path / "push.yaml").write_text(PUSH.replace("0.5s", "300s"))
    deaf = (
        "from app import player\n"
        "from app.cli import main\n"
        "import os, signal, sys\n"
        "tick = player.Player._tick\n"
        "class Lent:\n"
        "    def __del__(self):\n"
        "        os.kill(os.getpid(), signal.SIGINT)\n"
        "def swallowing(self, place):\n"
        "    Lent()\n"
        "    return tick(self, place)\n"
        "player.Player._tick = swallowing\n"
        "sys.argv = ['laws', 'render', 'push.yaml', '-o', 'a.gif', '-o', 'a.csv']\n"
        "main()\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", deaf],
        cwd=tmp_path,
        capture_output=True,
        env=surroundings(),
        timeout=60,
        check=False,
    )
    assert (done.returncode, done.stderr) == (130, b"")
    assert files(tmp_path) == ["push.yaml"]
