"""Words, fonts, icons and scenarios, found by name wherever the package is installed."""

from pathlib import Path

ROOT = Path(__file__).parent

FONTS = ROOT / "fonts"
SCENARIOS = ROOT / "scenarios"
TEXT = ROOT / "text"
TEMPLATES = ROOT / "templates"
