extends TestCase
## Roles are rows of capabilities.


func test_who_may_do_what() -> void:
	is_true(Roles.can(Roles.Role.TRAINEE, Roles.Capability.SEND_MOTION))
	is_false(Roles.can(Roles.Role.OBSERVER, Roles.Capability.SEND_MOTION))
	is_true(Roles.can(Roles.Role.INSTRUCTOR, Roles.Capability.MODERATE))
	is_false(Roles.can(Roles.Role.TRAINEE, Roles.Capability.DIRECT))
	for role: int in Roles.ROWS:
		is_true(Roles.can(role, Roles.Capability.COMMAND), Roles.name_of(role))
		equal(Roles.find(Roles.name_of(role)), role)


func test_who_is_nobody_may_nothing() -> void:
	for role: int in [-1, 3, 255]:
		is_false(Roles.is_role(role))
		is_false(Roles.can(role, Roles.Capability.COMMAND))
	equal(Roles.find("replay"), -1)


func test_every_role_has_a_row() -> void:
	equal(Roles.ROWS.size(), Roles.Role.size())


func test_names_of_roles() -> void:
	equal(Roles.names(), PackedStringArray(["observer", "trainee", "instructor"]))
	equal(Roles.names(Roles.Capability.SEND_MOTION), PackedStringArray(["trainee"]))
	for role: int in Roles.ROWS:
		not_equal(Roles.describe(role), "")
	equal(Roles.describe(-1), "")
