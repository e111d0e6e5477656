"""Listen to transforms for a while, then write the tree of frames to files."""

import argparse
import shutil
import subprocess
import sys
import time
from pathlib import Path

import rclpy
import yaml
from node_program.running import ros
from tf2_msgs.srv import FrameGraph
from tf2_ros import Buffer, TransformListener

from tf2_tools.graph import generate_dot, generate_svg


def parse(words):
    """Return the options of the command line."""
    parser = argparse.ArgumentParser(
        prog='view_frames', description='Create a diagram of the TF frames being broadcast over ROS'
    )
    parser.add_argument(
        '--wait-time',
        '-t',
        type=float,
        default=5.0,
        help='Listen to the /tf topic for this many seconds before rendering the frame tree',
    )
    parser.add_argument('-o', '--output', help='Output filename')
    return parser.parse_args(words)


def listen(node, executor, seconds):
    """Return the :class:`tf2_ros.Buffer` that has heard everything for so many seconds."""
    buffer = Buffer(node=node)
    listener = TransformListener(buffer, node)
    node.get_logger().info(f'Listening to tf data for {seconds} seconds...')
    end = time.monotonic() + seconds
    while (rest := end - time.monotonic()) > 0.0:
        executor.spin_once(timeout_sec=min(rest, 0.1))
    listener.unregister()
    return buffer


def write(stem, frame_yaml, recorded_time):
    """
    Write `stem`.yaml, `stem`.gv and the picture; return the picture's path.

    The picture is a PDF where Graphviz is installed, else an SVG.
    """
    # `[]` is an empty buffer's answer; and a frame's name may look like a number to YAML.
    data = {str(frame): entry for frame, entry in dict(yaml.safe_load(frame_yaml)).items()}
    Path(f'{stem}.yaml').write_text(frame_yaml)
    dot = Path(f'{stem}.gv')
    dot.write_text(generate_dot(data, recorded_time))
    graphviz = shutil.which('dot')
    if graphviz is not None:
        picture = Path(f'{stem}.pdf')
        if subprocess.run([graphviz, '-Tpdf', dot, '-o', picture], check=False).returncode == 0:
            return picture
    picture = Path(f'{stem}.svg')
    picture.write_text(generate_svg(data, recorded_time))
    return picture


def main():
    """Run the program."""
    with ros() as (words, executor):
        options = parse(words)
        node = rclpy.create_node('view_frames')
        executor.add_node(node)
        buffer = listen(node, executor, options.wait_time)
        logger = node.get_logger()
        logger.info('Generating graph...')
        answer = FrameGraph.Response(frame_yaml=buffer.all_frames_as_yaml())
        logger.info(f'Result:{answer}')
        stem = options.output or time.strftime('frames_%Y-%m-%d_%H.%M.%S')
        try:
            picture = write(stem, answer.frame_yaml, node.get_clock().now().seconds_nanoseconds())
        except (OSError, yaml.YAMLError) as error:  # a folder that is not there; a frame's name that is no YAML
            sys.exit(f'view_frames: {error}')
        logger.info(f'Exporting graph in {picture} file...')
