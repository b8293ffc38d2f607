extends TestCase
## Roles are rows of capabilities.


func test_who_may_do_what() -> void:
	is_true(Roles.can(Roles.Role.TRAINEE, Roles.Capability.SEND_MOTION))
	is_false(Roles.can(Roles.Role.OBSERVER, Roles.Capability.SEND_MOTION))
	is_true(Roles.can(Roles.Role.INSTRUCTOR, Roles.Capability.MODERATE))
	is_false(Roles.can(Roles.Role.TRAINEE, Roles.Capability.DIRECT))
	is_true(Roles.can(Roles.Role.OBSERVER, Roles.Capability.COMMAND))
	for role: int in Roles.ROWS:
		equal(Roles.find(Roles.name_of(role)), role)


func test_who_is_nobody_may_nothing() -> void:
	for role: int in [-1, Roles.ROWS.size(), 255]:
		is_false(Roles.is_role(role))
		is_false(Roles.can(role, Roles.Capability.COMMAND))
	equal(Roles.find("replay"), -1)


func test_every_role_has_a_row() -> void:
	equal(Roles.ROWS.size(), Roles.Role.size())


func test_names_of_roles() -> void:
	equal(Roles.names().slice(0, 3), PackedStringArray(["observer", "trainee", "instructor"]))
	for role: int in Roles.ROWS:
		var name: String = Roles.name_of(role)
		for capability: Roles.Capability in Roles.Capability.values():
			equal(Roles.names(capability).has(name), Roles.can(role, capability), name)
		not_equal(Roles.describe(role), "")
	equal(Roles.describe(-1), "")
