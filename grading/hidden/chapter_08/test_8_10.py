"""Hidden tests of exercise 8.10, start it: the whole package, built, launched and used."""

import pytest

from helpers.checks.chapter_08 import deliveries
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.10')


def story(learner) -> dict:
    """What happened, without what comes from a faulty launch."""
    told = deliveries.launched(learner)
    log = told['log']
    for word, why in (('InvalidParameterTypeException', 'A value in DELIVERY_YAML has the wrong type: all are doubles, '
                                                        '30.0 and not 30.'),
                      ('Error opening YAML file', 'The launch file names a parameter file that is not there. The '
                                                  'sources of the package are gone: FindPackageShare finds the '
                                                  'installed folder.'),
                      ("Couldn't parse params file", 'ROS cannot read DELIVERY_YAML.')):
        expect(word not in log, f'Your node did not start. {why}')
    expect('/delivery_robot' in told, f'The node /delivery_robot did not start: {told["last"]}')
    return told


@pytest.mark.weight(2)
def test_values(learner):
    """The node has the values of delivery.yaml, and simulated time.

    parameters=[path of the installed file, {'use_sim_time': True}].
    """
    values = story(learner)['/delivery_robot']
    expect(values['use_sim_time'] is True, 'The node /delivery_robot has use_sim_time False: it does not live in the '
                                           "world's time.")
    for name, wanted in (('max_linear', 0.4), ('tolerance', 0.08), ('timeout', 30.0), ('max_angular', 1.0)):
        expect(values[name] == wanted, f'{name} of /delivery_robot is {values[name]}, expected {wanted}. Does the name '
                                       'of the block fit, and does the launch file hand the file over?')


@pytest.mark.weight(2)
def test_world(learner):
    """The world gets the scene and the real_time_factor that were given to the launch.

    launch_arguments: pairs of a name and LaunchConfiguration(name).
    """
    values = story(learner).get('/world')
    expect(values, 'The node /world did not start: the launch file must include world.launch.py.')
    wanted = {'scene': 'empty', 'real_time_factor': 0.8}
    expect(values == wanted, f'Launched with scene:=empty real_time_factor:=0.8, the world has {values}.')


@pytest.mark.weight(4)
def test_drives(learner):
    """Launched, the robot drives off, stands when it is called back, and then reaches another station.

    The cells of exercises 8.5 and 8.7 to 8.9 are used here as files. Their own tests tell more.
    """
    told = story(learner)
    expect('missing' not in told, f'This never came: {told.get("missing")}. The last that the launch said: '
                                  f'{told["last"]}')
    expect(told['cancelled'] == 'canceled', f'The goal that was called back ended as {told["cancelled"]}, expected '
                                            'canceled.')
    expect(told['stopped_at'] < 5.0, f'The robot was called back on its way to x = 6 m, and stood at '
                                     f'{told["stopped_at"]:.2f} m.')
    expect(told['arrived'] == 'succeeded', f'The goal after that ended as {told["arrived"]}, expected succeeded.')
    expect(abs(told['ended_at'] - 1.0) < 0.2, f'The station is at x = 1 m, and the robot stands at '
                                              f'{told["ended_at"]:.2f} m.')


def test_ends(learner):
    """Ctrl+C ends all of it.

    main() of the package is given; does your launch file start anything that does not end?
    """
    status = story(learner)['status']
    expect(status == 0, f'After Ctrl+C, ros2 launch ended with the status {status}, expected 0.')
