# attack: puts scripts into exceptions, outputs and messages
# row: 37
# aims at: 90.1
# stopped by: every text is escaped where it is shown
# expect verdict: learner_crashed
# expect message: alert(1)
def total(numbers):
    tell('<script>alert(2)</script><img src=x onerror=alert(3)>')
    raise ValueError('<script>alert(1)</script><svg onload=alert(1)>"\'><iframe src="javascript:alert(1)">')
