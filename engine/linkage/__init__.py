"""How joints hold bodies together: what they constrain, and the equations that it takes."""
