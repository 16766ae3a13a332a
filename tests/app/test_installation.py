from app import installation


def test_a_program_that_runs_from_its_sources_has_no_version(monkeypatch):
    assert installation.own_version()[0].isdigit()
    monkeypatch.setattr(installation, "DISTRIBUTION", "no-such-distribution")
    assert installation.own_version() == "not installed"


def test_an_extra_is_named_with_the_command_that_installs_it():
    assert installation.extra_command("video") == 'python -m pip install "laws-of-motion[video]"'
