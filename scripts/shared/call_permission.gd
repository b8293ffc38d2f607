@tool
class_name CallPermission
extends Resource
## Which roles may call a method of [SharedNodes] on the server, and how often.

## Name of a method with [code]@rpc("any_peer")[/code].
@export var method: StringName = &""
## Who may call it.
@export_flags("Observer:1", "Trainee:2", "Instructor:4") var roles: int = 6
## Calls of one client in a second; more are refused.
@export_range(1, 60, 1, "suffix:/s") var calls_per_second: int = 10


## Whether a role may call it.
func allows(p_role: Roles.Role) -> bool:
	return roles & (1 << p_role) != 0
