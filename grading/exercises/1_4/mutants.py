from grading.variants import Mutant

ALL = ('reach', 'stop', 'walls', 'short-way')
STOP = '''
        if distance > 0.05:
            command.angular.z = 3.0 * error
            if abs(error) < 0.3:
                command.linear.x = min(1.5 * distance, 2.0)
        '''

MUTANTS = [
    Mutant('goal_in_front_is_enough', old='if abs(error) < 0.3:', new='if abs(error) < 1.5:', breaks='short-way',
           expect='nearly as fast as ever'),
    Mutant('absolute_topics', edits=(("Twist, 'turtle1/cmd_vel'", "Twist, '/turtle1/cmd_vel'"),
            ("Pose, 'turtle1/pose'", "Pose, '/turtle1/pose'")), expect='a relative name has no slash', breaks='topics'),
    Mutant('atan_of_the_quotient', old='.atan2(dy, dx)', new='.atan(dy / dx if dx else 1e9)', expect='ran into a wall',
           breaks='walls', also=ALL),
    Mutant('degrees', old='.atan2(dy, dx)', new='.degrees(math.atan2(dy, dx))', expect='From (', breaks='reach',
           also=ALL),
    Mutant('depth_1', old="'turtle1/cmd_vel', 10)", new="'turtle1/cmd_vel', 1)", expect='has the depth 1, expected 10',
           breaks='topics'),
    Mutant('drives_while_turning', old='''
        if abs(error) < 0.3:
            command.linear.x = min(1.5 * distance, 2.0)
        ''', new='''
        command.angular.z = 1.5 * error
        command.linear.x = 2.0
        ''', expect='ran into a wall', breaks='walls', also=ALL),
    Mutant('exchanged_x_and_y', old='math.atan2(dy, dx)', new='math.atan2(dx, dy)', expect='From (', breaks='reach',
           also=ALL),
    Mutant('fixed_goal', old='self.x, self.y = x, y', new='self.x, self.y = 2.0, 9.0', expect='From (', breaks='reach',
           also=ALL),
    Mutant('half_a_metre_is_near', old='if distance > 0.05:', new='if distance > 0.5:', expect='m away',
           breaks='reach', also=ALL),
    Mutant('ignores_the_heading', old='atan2(dy, dx) - pose.theta, 2 * math', new='atan2(dy, dx), 2 * math',
           expect='From (', breaks='reach', also=ALL),
    Mutant('long_way_round', old='error = math.remainder(math.atan2(dy, dx) - pose.theta, 2 * math.pi)',
           new='error = math.atan2(dy, dx) - pose.theta', expect='the long way round', breaks='short-way',
           also=('reach', 'walls')),
    Mutant('always_to_the_left', old='error = math.remainder(math.atan2(dy, dx) - pose.theta, 2 * math.pi)',
           new='error = (math.atan2(dy, dx) - pose.theta) % (2 * math.pi)', expect='° to the right, and the turtle',
           breaks='short-way', also=ALL),
    Mutant('never_stops', old=STOP, new='''
        command.angular.z = 3.0 * error
        command.linear.x = 0.5
        ''', expect='From (', breaks='stop', also=ALL),
    Mutant('only_turns', old='min(1.5 * distance, 2.0)', new='0.0', expect='m away', breaks='reach', also=ALL),
    Mutant('other_name', old="'go_to_goal'", new="'goal'", expect='The node is called', breaks='node'),
    Mutant('returns_at_the_goal', old=STOP, new='''
        if distance <= 0.05:
            return
        command.angular.z = 3.0 * error
        if abs(error) < 0.3:
            command.linear.x = min(1.5 * distance, 2.0)
        ''', expect='Publish a command of zero there', breaks='stop'),
    Mutant('too_slow', old='min(1.5 * distance, 2.0)', new='min(distance, 0.6)', expect='m away', breaks='reach',
           also=ALL),
    Mutant('in_an_arc', old='if abs(error) < 0.3:', new='if abs(error) < 2.5:', expect='ran into a wall', breaks='walls',
           also=ALL),
    Mutant('backwards', old='''
        command.angular.z = 3.0 * error
        if abs(error) < 0.3:
            command.linear.x = min(1.5 * distance, 2.0)
        ''', new='''
        turn = math.remainder(error, math.pi)
        command.angular.z = 3.0 * turn
        if abs(turn) < 0.3:
            command.linear.x = math.copysign(min(1.5 * distance, 2.0), math.cos(error))
        ''', expect='drive backwards', breaks='short-way', also=ALL),
    Mutant('turns_at_the_goal', old=STOP, new='''
        command.angular.z = 3.0 * error
        if distance > 0.05 and abs(error) < 0.3:
            command.linear.x = min(1.5 * distance, 2.0)
        ''', expect='the last command on', breaks='stop', also=ALL),
    Mutant('goal_in_a_point', edits=(('self.x, self.y = x, y', """
            from geometry_msgs.msg import Point
            self.goal = Point(x=x, y=y)
            """), ('self.x - pose.x, self.y - pose.y', 'self.goal.x - pose.x, self.goal.y - pose.y')),
           expect="must be of type 'float'", breaks='reach'),
    Mutant('slides_sideways', old='command.angular.z = 3.0 * error', new="""
            command.angular.z = 3.0 * error
            command.linear.y = 0.2 * math.sin(error)
            """, expect='slide sideways', breaks='short-way'),
    Mutant('one_coordinate', old='if distance > 0.05:', new='if abs(dx) > 0.05:', expect='From (', breaks='reach',
           also=ALL),
    Mutant('backwards_if_it_is_behind', old='''
        command.angular.z = 3.0 * error
        if abs(error) < 0.3:
            command.linear.x = min(1.5 * distance, 2.0)
        ''', new='''
        behind = abs(error) > math.pi - 0.3
        command.angular.z = 3.0 * (math.remainder(error, math.pi) if behind else error)
        if behind or abs(error) < 0.3:
            command.linear.x = math.copysign(min(1.5 * distance, 2.0), math.cos(error))
        ''', expect='drive backwards', breaks='short-way', also=ALL),
    Mutant('slowly_while_it_turns', old='''
        command.angular.z = 3.0 * error
        ''', new='''
        command.angular.z = 3.0 * error
        command.linear.x = 0.3
        ''', expect='drove with 0.30 m/s while the goal was behind it', breaks='short-way', also=ALL),
    Mutant('far_to_the_left', old='command.angular.z = 3.0 * error', breaks='short-way',
           new='command.angular.z = 3.0 * (abs(error) if abs(error) > 2.0 else error)', expect='the long way round'),
    Mutant('far_to_the_right', old='command.angular.z = 3.0 * error', breaks='short-way',
           new='command.angular.z = 3.0 * (-abs(error) if abs(error) > 2.0 else error)', expect='the long way round'),
    Mutant('goal_in_the_class', edits=(('self.x, self.y = x, y', 'GoToGoal.x, GoToGoal.y = x, y'),),
           expect='the goal of a second object of your class', breaks='reach'),
    Mutant('near_is_straight_ahead', old='if abs(error) < 0.3:', new='if abs(error) < 0.3 or distance < 0.5:',
           expect='Turn first, also if the goal is near', breaks='short-way'),
    Mutant('thirty_centimetres_are_straight_ahead', old='if abs(error) < 0.3:', new='if abs(error) < 0.3 or distance < 0.3:',
           expect='Turn first, also if the goal is near', breaks='short-way'),
    Mutant('arrived_for_all', edits=(('self.x, self.y = x, y', 'self.x, self.y = x, y; GoToGoal.arrived = False'),
                                     ('if distance > 0.05:', '''
                                     GoToGoal.arrived = GoToGoal.arrived or distance <= 0.05
                                     if not GoToGoal.arrived:
                                     ''')),
           expect='A second object of your class, in another namespace, drove', breaks='reach'),
    Mutant('near_in_each_direction', old='if distance > 0.05:', new='if max(abs(dx), abs(dy)) > 0.099:',
           expect='and must come to 0.1 m and stay', breaks='reach', also=ALL),
]
