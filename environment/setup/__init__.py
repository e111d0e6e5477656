"""Makes `.venv`: a virtual environment that is a ROS 2 Jazzy installation.

Standard library only, as it runs before anything is installed. `./course` calls `environment.setup.main`.
"""
