extends TestCase
## What an address counts as.


func test_networks() -> void:
	var rows: Array[PackedStringArray] = [
		["10.1.2.3", "10.1.2.3", "10.1.2", "10.1.2.3"],
		["::ffff:10.1.2.3", "10.1.2.3", "10.1.2", "10.1.2.3"],
		["0:0:0:0:0:ffff:a01:203", "10.1.2.3", "10.1.2", "10.1.2.3"],
		["2001:db8:1:2:3:4:5:6", "2001:db8:1:2::", "2001:db8:1::", "2001:db8:1::"],
		["2001:DB8:1:2::6", "2001:db8:1:2::", "2001:db8:1::", "2001:db8:1::"],
		["2001:db8::6", "2001:db8:0:0::", "2001:db8:0::", "2001:db8:0::"],
		["fe80::1%eth0", "fe80:0:0:0::", "fe80:0:0::", "fe80:0:0::"],
		["::1", "0:0:0:0::", "0:0:0::", "0:0:0::"],
		["nonsense", "nonsense", "nonsense", "nonsense"],
		["", "", "", ""],
	]
	for row: PackedStringArray in rows:
		var of: String = AddressNetwork.of(row[0])
		equal(
			[of, AddressNetwork.around(row[0]), AddressNetwork.site_of(row[0])],
			[row[1], row[2], row[3]]
		)
