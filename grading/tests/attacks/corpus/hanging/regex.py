# attack: runs a regular expression that takes for ever
# row: 14
# aims at: 90.2
# stopped by: each call is waited for within a bound
# expect verdict: timeout
# expect message: did not return
def flip(text):
    re.match(r'(a+)+$', 'a' * 60 + 'b')
