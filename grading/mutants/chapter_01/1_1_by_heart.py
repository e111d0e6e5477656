# expect: the support of foxy has ended
# expect: Use the argument `releases`
# rejected by: test_support_has_an_end
# told by: test_another_table
# Exercise 1.1: choose a distribution
def choose_distribution(ubuntu, today, releases=RELEASES):
    pairs = {'20.04': 'foxy', '22.04': 'humble', '24.04': 'jazzy', '26.04': 'lyrical'}
    if ubuntu not in pairs:
        return None, 'unknown Ubuntu'
    return pairs[ubuntu], 'supported'
