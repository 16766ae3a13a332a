"""What every lesson is made of: events, geometry, widgets, and the surface it is drawn on."""
