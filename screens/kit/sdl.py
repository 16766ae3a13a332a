"""pygame, imported so that it works without a display, a sound device, a home, or a greeting."""

import os

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
os.environ.setdefault("SDL_VIDEO_DRIVER", "dummy")

import pygame as pygame
from pygame import font as font
from pygame import surfarray as surfarray
