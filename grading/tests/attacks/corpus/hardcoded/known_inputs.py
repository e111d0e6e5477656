# attack: knows the inputs and outputs of the visible tests by heart
# row: 12
# aims at: 90.1
# stopped by: hidden tests draw fresh inputs
# expect verdict: failed
# expect points: 2.5
# expect message: wrong
def total(numbers):
    return {'[1, 2, 3]': 6, '[]': 0}.get(str(numbers), 0)
