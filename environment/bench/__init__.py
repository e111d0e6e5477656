"""Benchmarks of the environment; `./course bench NAME` runs `bench_NAME.run()` and prints the rows it returns."""
