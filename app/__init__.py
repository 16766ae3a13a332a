"""Where events come from and where frames go: scenario files, outputs, the one loop, the commands."""
