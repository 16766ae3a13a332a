"""Where events come from and where frames go: scenarios, outputs, the one loop, the commands."""
