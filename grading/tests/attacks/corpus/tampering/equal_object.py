# attack: returns an object that says it equals everything
# row: 3
# aims at: 90.2
# stopped by: of other objects only the name of their type travels
# expect verdict: failed
# expect message: an object of type Always
class Always:
    def __eq__(self, other):
        return True

    def __str__(self):
        return 'cba'


def flip(text):
    return Always()
