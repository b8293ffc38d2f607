extends TestCase
## What --source takes, and what it says about the rest.


func test_kinds_with_and_without_an_address() -> void:
	equal(SourceAddress.parse("vmc").port, 39539)
	equal(SourceAddress.parse("vmc:40000").port, 40000)
	equal(SourceAddress.parse("mvn").port, 9763)
	equal(SourceAddress.parse("slime").port, 6969)
	equal(SourceAddress.parse("natnet:10.0.0.7").host, "10.0.0.7")
	equal(SourceAddress.parse("tracker:/user/body_tracker").text, "/user/body_tracker")
	equal(SourceAddress.parse("bvh:/tmp/a:b.bvh").text, "/tmp/a:b.bvh")
	var tcp: SourceAddress = SourceAddress.parse("axis:tcp:10.0.0.5:7001")
	equal(tcp.fault, "")
	is_true(tcp.is_tcp)
	equal([tcp.host, tcp.port], ["10.0.0.5", 7001])
	for kind: String in SourceAddress.KINDS:
		if SourceAddress.FORMS[SourceAddress.KINDS[kind]].begins_with("["):
			equal(SourceAddress.parse(kind).fault, "")


func test_what_is_wrong_is_told_with_all_kinds() -> void:
	var texts: PackedStringArray = ["", "vcm", "vmc:", "vmc:0", "vmc:70000", "vmc:x", "xbus:1"]
	texts.append_array(["tracker", "tracker:", "bvh", "axis:tcp:host", "axis:tcp::1", "natnet:"])
	texts.append_array(["natnet:a b", "mvn:9763:1", "axis:tcp:h:1:2"])
	for text: String in texts:
		var fault: String = SourceAddress.parse(text).fault
		for kind: String in SourceAddress.KINDS:
			contains(fault, kind, "'%s'" % text)
	contains(SourceAddress.parse("vcm").fault, "did you mean vmc")


func test_several_sources_in_one_text() -> void:
	var found: Array[SourceAddress] = SourceAddress.parse_list("vmc:1,bvh:a.bvh,b.bvh,slime,x")
	equal(
		found.map(func(one: SourceAddress) -> String: return one.kind), ["vmc", "bvh", "slime", "x"]
	)
	equal(found[1].text, "a.bvh,b.bvh")
	not_equal(found[3].fault, "")
