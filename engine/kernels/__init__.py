"""What computes: plain functions over tables, interpreted or compiled; `tick` is the outermost."""
