# attack: knows the answer of the visible test by heart
# row: 12
# aims at: 90.2
# stopped by: hidden tests draw fresh inputs
# expect verdict: failed
# expect points: 2.5
# expect message: 20 letters
def flip(text):
    return 'cba'
