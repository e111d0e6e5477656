# attack: returns texts that no file can hold
# row: 36
# aims at: 90.2
# stopped by: text is cleaned before it is written
# expect verdict: failed or learner_crashed
# expect message: flip
def flip(text):
    return '\ud800\udfff\x00' * 10
