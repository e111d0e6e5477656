#!/usr/bin/env bash
# Runs once, as root, when Gradescope builds the image: system packages, then the course's own environment.
# AUTOGRADER_ROOT is for tests of this script; on Gradescope it is /autograder.
set -euo pipefail
root=${AUTOGRADER_ROOT:-/autograder}

export DEBIAN_FRONTEND=noninteractive
apt-get update -q
apt-get install -q -y --no-install-recommends g++ python3 python3-dev python3-venv bubblewrap

cd "$root/source/course"
# This makes .venv. What it prints is in the image's build log.
./course setup
