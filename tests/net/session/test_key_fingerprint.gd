extends TestCase
## Fingerprints are what ssh would show, and only those are taken.


func test_a_fingerprint_is_the_hash_of_the_key_in_base64() -> void:
	var key: PackedByteArray = []
	key.resize(KeyFingerprint.KEY_SIZE)
	# printf '\0%.0s' {1..32} | openssl dgst -sha256 -binary | base64
	equal(KeyFingerprint.of(key), "SHA256:Zmh6rfhivXdsj8GLjp+OIAiXFIVu4jOzkCpZHQ1fKSU")


func test_bytes_come_back_from_their_text_and_nothing_from_others() -> void:
	var key: PackedByteArray = Crypto.new().generate_random_bytes(KeyFingerprint.KEY_SIZE)
	var text: String = KeyFingerprint.to_text(key)
	equal(text.length(), 43)
	equal(KeyFingerprint.from_text(text), key)
	for wrong: String in ["", text + "=", text.left(42), text.left(42) + "B", " " + text.left(42)]:
		equal(KeyFingerprint.from_text(wrong).size(), 0, wrong)


func test_a_text_that_is_no_fingerprint_is_named() -> void:
	var key: PackedByteArray = Crypto.new().generate_random_bytes(KeyFingerprint.KEY_SIZE)
	equal(KeyFingerprint.find_fault(KeyFingerprint.of(key)), "")
	for wrong: String in ["", "SHA256:", "SHA256:abc", KeyFingerprint.to_text(key), "MD5:12:34"]:
		contains(KeyFingerprint.find_fault(wrong), "'%s'" % wrong)
