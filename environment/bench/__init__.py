"""Benchmarks of the environment; `./course bench NAME` runs `bench_NAME.measure()` (see `grading.bench`)."""
