# attack: writes commands for the system that runs the grader
# row: 38
# aims at: 90.1
# stopped by: the grader's own output never begins with a learner's text
# expect verdict: learner_crashed
# expect message: your code raised
def total(numbers):
    for line in ('::stop-commands::x', '::set-output name=score::100', '##vso[task.complete result=Succeeded;]',
                 '::add-mask::a', '##teamcity[testFinished]'):
        tell(line)
    raise ValueError('\n::error::all is well\n::set-output name=score::100')
