extends TestCase
## What somebody may have meant who mistyped a name.


func test_a_letter_may_be_wrong_missing_too_many_or_exchanged() -> void:
	var known: PackedStringArray = ["port", "person", "password", "max-clients"]
	for word: String in ["prot", "pot", "poort", "pord", "PORT"]:
		equal(Nearest.find(word, known), "port")
	equal(Nearest.find("persn", known), "person")
	equal(Nearest.find("max-client", known), "max-clients")
	equal(Nearest.suggest("persn", known, "--"), ": did you mean --person?")


func test_what_is_like_nothing_is_not_guessed() -> void:
	var known: PackedStringArray = ["port", "person"]
	for word: String in ["", "nonsense", "x", "p".repeat(5000)]:
		equal(Nearest.find(word, known), "")
		equal(Nearest.suggest(word, known), "")
	equal(Nearest.find("port", []), "")


func test_edits_are_counted() -> void:
	equal(Nearest.count_edits("", "abc"), 3)
	equal(Nearest.count_edits("abc", ""), 3)
	equal(Nearest.count_edits("kitten", "sitting"), 3)
	equal(Nearest.count_edits("abcd", "abdc"), 1)
	equal(Nearest.count_edits("same", "same"), 0)
