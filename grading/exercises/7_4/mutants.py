from grading.variants import Mutant

STACKS = {'also': ('own-call', 'all')}
HEALTHY = {'also': ('all',), 'breaks': 'healthy'}
CALLBACK = "if 'await_or_execute' in [function for _, _, function in calls[own:]] and not cause:"
CAUSE = "cause = 'call' if ('client.py', 'call') in newer else 'spin' if spins else 'busy'"

MUTANTS = [
    Mutant('no_server', old="cause = 'server' if ('client.py', 'wait_for_service') in newer else ''", new="cause = ''",
           breaks='server', expect='A thread that waits in wait_for_service', **STACKS),
    Mutant('server_in_callbacks_only', old="('client.py', 'wait_for_service') in newer else ''",
           new="('client.py', 'wait_for_service') in newer and 'await_or_execute' in stacks else ''", breaks='server',
           expect='in a callback or not', **STACKS),
    Mutant('server_has_the_fault_of_the_others', old="'waiting' if cause == 'server' else 'hang'", new="'hang'",
           breaks='server', expect='your `fault` is', **STACKS),
    Mutant('no_call', old=CAUSE, new="cause = 'spin' if spins else 'busy'", breaks='call',
           expect='waits for an answer that the same thread', **STACKS),
    Mutant('newest_call_decides', old=CAUSE, new="cause = 'call' if newer else 'busy'", breaks='spin',
           also=('busy', 'all'), expect='A callback that spins'),
    Mutant('no_busy', old=CAUSE, new="cause = 'call' if ('client.py', 'call') in newer else 'spin' if spins else ''",
           breaks='busy', expect='does not return', **STACKS),
    Mutant('main_thread_too', old=CALLBACK, new='if not cause:', expect='there is no such fault',
           breaks='healthy', also=('all', 'spin')),
    Mutant('call_in_main_too', old='return found\n', new="""
    for thread in re.split(THREAD, stacks):
        if 'in call' in thread and 'await_or_execute' not in thread:
            found.append(Finding('hang', 'main', 'call', ''))
    return found
""", expect='there is no such fault', **HEALTHY),
    Mutant('own_line_in_main_too', old=CALLBACK, expect='there is no such fault', **HEALTHY,
           new="if ('await_or_execute' in [function for _, _, function in calls[own:]] or not own) and not cause:"),
    Mutant('oldest_own_call', old='own = mine[0]', new='own = mine[-2] if len(mine) > 2 else mine[0]',
           breaks='own-call', also='all', expect='You did not find'),
    Mutant('name_of_the_file_only', old="if path.name in files and path.parent.name != 'rclpy']",
           new='if path.name in files]', breaks='own-call', also=('all', 'healthy'), expect='list index out of range'),
    Mutant('first_thread_only', old='    return found\n', new='    return found[:1]\n', breaks='all',
           expect='You did not find'),
    Mutant('current_thread_is_none', old='re.split(THREAD, stacks)', new=r"re.split(r'\nThread 0x', stacks)", breaks='all',
           expect='You did not find'),
    Mutant('no_word_before_the_answer', old="print('answer:', future", new="print(future", breaks='answer',
           expect='the client printed'),
    Mutant('no_status_without_a_server', old="    sys.exit(f'no server for {sys.argv[1]}')",
           new="    print(f'no server for {sys.argv[1]}')\n    sys.exit()", breaks='no-server',
           expect='ended with status 0'),
    Mutant('no_name_of_the_service', old="f'no server for {sys.argv[1]}'", new="'no server'", breaks='no-server',
           expect='the client printed `no server`'),
    Mutant('waits_for_the_answer_for_ever', old='(node, future, timeout_sec=patience)', new='(node, future)',
           breaks='no-answer', expect='waits on and on'),
    Mutant('swallows_ctrl_c', old='if not client.wait_for_service(timeout_sec=patience):', new='''
        import time
        end = time.time() + patience
        while time.time() < end:
            try:
                if client.wait_for_service(timeout_sec=0.1):
                    break
            except:
                pass
        else:
        ''', breaks='interrupt', expect='within two seconds after Ctrl+C'),
    Mutant('calls_of_other_libraries', old="zip(paths[:own], calls) if path.parent.name == 'rclpy'}",
           new='zip(paths[:own], calls)}', breaks='own-call', also=('all', 'busy', 'healthy'), expect='You did not find'),
    Mutant('three_ways_to_spin', old="'executors.py' in [name for name, _ in newer]",
           new="{'spin', 'spin_once', 'spin_until_future_complete'} & {function for _, function in newer}", breaks='spin',
           expect='A callback that spins', also=('own-call', 'all')),
    Mutant('a_second_for_the_server', old='wait_for_service(timeout_sec=patience)', new='wait_for_service(timeout_sec=1.0)',
           breaks='no-server', also='answer', expect='command line'),
    Mutant('a_second_for_the_answer', old='future, timeout_sec=patience)', new='future, timeout_sec=1.0)',
           breaks='no-answer', also='answer', expect='and ended after'),
    Mutant('whole_seconds', old='float(sys.argv[2])', new='float(int(float(sys.argv[2])))', breaks='no-server',
           also='no-answer', expect='no more and no less'),
    Mutant('empty_answer_is_none', old='if not future.done():', new='if not (future.done() and future.result().message):',
           breaks='answer', expect='whose message is empty'),
    Mutant('one_time_for_both', old='rclpy.init()', new='rclpy.init(); import time',
           edits=(('(timeout_sec=patience):', '(timeout_sec=patience - 0 * (begin := time.monotonic())):'),
           ('future, timeout_sec=patience)', 'future, timeout_sec=max(0.0, patience + begin - time.monotonic()))')),
           breaks='answer', expect='for each of the two'),
    Mutant('every_call_of_client_py', old="if ('client.py', 'call') in newer", breaks='busy', also='all',
           new="if [one for one in newer if one[0] == 'client.py' and one[1].startswith('call')]",
           expect='Of the calls in client.py'),
    Mutant('ten_times_as_patient', old='future, timeout_sec=patience)', new='future, timeout_sec=10 * patience)',
           breaks='no-answer', expect='waits on and on'),
    Mutant('looks_when_the_time_is_over', old='rclpy.spin_until_future_complete(node, future, timeout_sec=patience)', new='''
        import time
        end = time.monotonic() + patience
        while time.monotonic() < end:
            rclpy.spin_once(node, timeout_sec=0.1)
        ''', breaks='answer', expect='the answer ends the wait'),
    Mutant('callback_of_rclpy', old='for _, _, function in calls[own:]]', new='for _, _, function in calls]',
           breaks='healthy', also=('all', 'own-call'), expect='its own call is no callback'),
    Mutant('server_is_the_newest_call', old="('client.py', 'wait_for_service') in newer else ''", breaks='server',
           new="own and calls[0][2] == 'wait_for_service' and paths[0].parent.name == 'rclpy' else ''",
           expect='A thread that waits in wait_for_service', **STACKS),
    Mutant('same_line_once', old='    return found\n', breaks='all', expect='with the same four parts',
           new='    return [one for number, one in enumerate(found) if one not in found[:number]]\n'),
    Mutant('rclpy_in_the_name_of_a_folder', old="path.parent.name != 'rclpy']", new="'rclpy' not in str(path)]",
           breaks='own-call', also='all', expect='You did not find'),
    Mutant('pool_waits_for_the_answer', old='rclpy.spin_until_future_complete(node, future, timeout_sec=patience)', new="""
        from concurrent.futures import ThreadPoolExecutor
        import os, time
        with ThreadPoolExecutor() as pool:
            waits = pool.submit(lambda: [time.sleep(0.1) for _ in range(10**6) if not future.done()])
            rclpy.spin_until_future_complete(node, future, timeout_sec=patience)
            if not future.done():
                print('no answer', flush=True)
                os._exit(1)
        """, breaks='interrupt', expect='also for those of a pool'),
    Mutant('line_without_its_comment', old='[int(line) - 1].strip()', new="[int(line) - 1].split('#')[0].strip()",
           breaks='own-call', also=('spin', 'busy', 'all'), expect='your evidence is'),
    Mutant('empty_lines_are_no_lines', old='files[Path(file).name].splitlines()',
           new="(files[Path(file).name].replace('\\n\\n', '\\n') + '\\n' * 99).splitlines()", breaks='own-call',
           also=('server', 'call', 'spin', 'busy', 'all'), expect='your evidence is'),
    Mutant('two_files_are_rclpys', old="path.parent.name != 'rclpy']", breaks='own-call', also='healthy',
           new="not str(path).endswith(('rclpy/client.py', 'rclpy/executors.py'))]", expect='list index out of range'),
    # As a daemon that still spins ends the program, often.
    Mutant('thread_spins_to_the_end', old="print('answer:', future.result().message)", new="""
        import os
        print('answer:', future.result().message, flush=True)
        os.write(2, b'terminate called without an active exception\\n')
        os.abort()
        """, breaks='answer', expect='call rclpy.try_shutdown() and join it'),
    Mutant('with_of_a_later_distribution', old='rclpy.init()', new='with rclpy.init(): pass', breaks='answer',
           also=('no-server', 'no-answer', 'interrupt'), expect='that works from the distribution after Jazzy on'),
    Mutant('what_is_installed_is_rclpys', old="path.parent.name != 'rclpy']", new="'site-packages' not in str(path)]",
           breaks='own-call', also=('server', 'call', 'spin', 'busy', 'all'), expect='You did not find'),
    Mutant('whatever_executes', old="'await_or_execute' in [function for _, _, function in calls[own:]]",
           new="[function for _, _, function in calls[own:] if 'execute' in function]", expect='there is no such fault', **HEALTHY),
    Mutant('callbacks_by_their_names', breaks='busy', also=('call', 'spin', 'all', 'healthy', 'own-call'),
           old="'await_or_execute' in [function for _, _, function in calls[own:]]",
           new="any(function.startswith('on_') for _, _, function in calls[own:])",
           expect='You did not find `hang`'),
    Mutant('seconds_with_a_point', old='float(sys.argv[2])', breaks='interrupt', expect=('without Ctrl+C', 'IndexError'),
           new="sum(map(float, [sys.argv[2].split('.')[0], '0.' + sys.argv[2].split('.')[1]]))"),
    Mutant('spaces_after_the_line', old='[int(line) - 1].strip()', new='[int(line) - 1].lstrip()', breaks='own-call',
           also=('server', 'call', 'spin', 'busy', 'all'), expect='your evidence is'),
    Mutant('in_a_callback_by_the_file', old="'await_or_execute' in [function for _, _, function in calls[own:]]",
           new="'executors.py' in [path.name for path in paths[own:]]", expect='That is no callback', breaks='healthy',
           also=('own-call', 'call', 'spin', 'busy', 'all')),
    Mutant('call_of_any_library', old="cause = 'call' if ('client.py', 'call') in newer else",
           new="cause = 'call' if 'call' in [call[2] for call in calls[:own]] else",
           expect='is none of rclpy', breaks='busy', also=('own-call', 'call', 'all')),
]
