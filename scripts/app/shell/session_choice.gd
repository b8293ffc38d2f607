class_name SessionChoice
extends RefCounted
## The session that a user of the start screen wants to begin: as what, where, and by which options.

## Name of the role, see [ProgramRoles].
var role: String = Roles.name_of(Roles.Role.OBSERVER)
## Address of the server: a name, an IPv4 or an IPv6 address. Empty: the role needs no server.
var host: String = ""
## UDP port of the server, 1 to 65535.
var port: int = Protocol.DEFAULT_PORT
## The name under which others see the user. Empty: that of the role.
var name: String = ""
## The server's password. Empty: it asks for none.
var password: String = ""
## Further options of the program, each as [code]--name=value[/code].
var more: PackedStringArray = []


## The options that begin this session.
func arguments() -> PackedStringArray:
	var result: PackedStringArray = ["--role=" + role]
	if host != "":
		result.append("--host=" + host)
		result.append("--port=%d" % port)
	if name != "":
		result.append("--name=" + name)
	if password != "":
		result.append("--password=" + password)
	result.append_array(more)
	return result
