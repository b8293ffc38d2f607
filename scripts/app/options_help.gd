class_name OptionsHelp
extends RefCounted
## The rows of [ProgramOptions] and [ProgramRoles] as texts: for the terminal, and docs/options.md.

## Path of the document, and the command that renews it.
const DOCUMENT: String = "res://docs/options.md"
const RENEW: String = "./run options-doc"

const _COLUMN: int = 34
## Characters of a line on a terminal.
const _WIDTH: int = 100
const _INTRODUCTION: Array[String] = [
	"# Options\n\n",
	"Made by `%s` from the `..._options.gd` of each feature; `./test lint` fails where",
	" they differ.\n\nOptions are given as `--name=value` or `--name value`, or by the environment:",
	" `DISMOUNT_MAX_CLIENTS=8` is `--max-clients=8`, or by a file (below). Arguments win. A role",
	" refuses an option that it does not take; in the environment, which several roles share, it",
	" passes over it. Relative files count from where you started the program. `./run ROLE --help`",
	" lists what a role takes. The other commands of `./run` have options of their own: `./run",
	" --help`.\n\n",
	"**A configuration file** has any of them: `--config=FILE` (or `DISMOUNT_CONFIG`). The command",
	" line wins over the environment, that over the file. Lines above any heading are for the role",
	" that reads the file; `[all]` is for each role that takes them. Relative files count from where",
	" you started the program, as in the command line. Mistakes are named with their line, and",
	" nothing starts.\n\n```\n; server.cfg\n[server]\nworld = hall\nmax-clients = 8\n",
	'password = "two words"\nwaiting-room = true\nlog-file = /var/log/dismount.log\n```\n\n',
	"SIGHUP lets a server open its log file anew and read configuration and bans again. %s take",
	" effect at once, which the log says; others with the next start. Of a file or a list of bans",
	" with a mistake nothing is taken.\n\n",
	"Exit codes: 0 done, 1 failed, 2 wrong options or motion file, 3 refused by the server, 4 no",
	" server (with `--connect-timeout`).\n\n## Roles\n\n| role | what it does |\n|---|---|\n",
]


## The options of a role, or of all roles if there is no such role; for the terminal.
static func describe(p_role: String) -> String:
	var is_role: bool = ProgramRoles.names().has(p_role)
	var lines: PackedStringArray = []
	if is_role:
		lines.append("%s: %s" % [p_role, ProgramRoles.describe(p_role)])
	else:
		lines.append("Roles (--role=NAME --help lists the options of one)")
		for role: String in ProgramRoles.names():
			lines.append("  %s%s" % [role.rpad(_COLUMN - 2), ProgramRoles.describe(role)])
	var groups: Dictionary[String, Array] = _by_roles()
	for heading: String in groups:
		var rows: Array = groups[heading]
		if is_role:
			rows = rows.filter(func(row: OptionRow) -> bool: return row.roles.has(p_role))
		else:
			lines.append("\nOptions of %s" % heading)
		for row: OptionRow in rows:
			lines.append(_line(row))
	lines.append("\nAlso by the environment: DISMOUNT_PORT=7778 is --port=7778.")
	return "\n".join(lines)


## What --help prints of each role, with a line "=== ROLE" before it.
static func all_roles() -> String:
	var parts: PackedStringArray = []
	for role: String in ProgramRoles.names():
		parts.append("=== %s\n%s\n" % [role, describe(role)])
	return "\n".join(parts)


## The text of docs/options.md.
static func document() -> String:
	var lines: PackedStringArray = []
	for role: String in ProgramRoles.names():
		lines.append("| `%s` | %s |" % [role, ProgramRoles.describe(role)])
	var groups: Dictionary[String, Array] = _by_roles()
	for heading: String in groups:
		lines.append("\n## For %s\n" % heading)
		lines.append("| option | default | can be | meaning |\n|---|---|---|---|")
		for row: OptionRow in groups[heading]:
			var cells: Array = [
				_cell(row.usage()),
				_cell(row.describe_default()) if row.kind != OptionRow.Kind.FLAG else "",
				row.describe_range(),
				row.meaning
			]
			lines.append("| %s | %s | %s | %s |" % cells)
	var live: String = "`--%s`" % "`, `--".join(ServerReload.CHANGEABLE)
	return "".join(_INTRODUCTION) % [RENEW, live] + "\n".join(lines) + "\n"


## Options by the roles that take them, in the order of the rows.
static func _by_roles() -> Dictionary[String, Array]:
	var groups: Dictionary[String, Array] = {}
	for row: OptionRow in ProgramOptions.rows():
		var heading: String = ", ".join(row.roles)
		if row.roles == ProgramRoles.names():
			heading = "all roles"
		groups.get_or_add(heading, []).append(row)
	return groups


static func _line(p_row: OptionRow) -> String:
	var notes: PackedStringArray = []
	if p_row.describe_range() != "":
		notes.append(p_row.describe_range())
	if p_row.describe_default() != "" and p_row.kind != OptionRow.Kind.FLAG:
		notes.append("default " + p_row.describe_default())
	var note: String = " [%s]" % "; ".join(notes) if not notes.is_empty() else ""
	var lines: PackedStringArray = _wrap(p_row.meaning + note, _WIDTH - _COLUMN)
	var usage: String = "  " + p_row.usage()
	if usage.length() >= _COLUMN:
		lines.insert(0, "")
	for i: int in lines.size():
		lines[i] = (usage if i == 0 else "").rpad(_COLUMN) + lines[i]
	return "\n".join(lines)


## A text as lines of a maximum of characters, broken between words.
static func _wrap(p_text: String, p_width: int) -> PackedStringArray:
	var lines: PackedStringArray = [""]
	for word: String in p_text.split(" "):
		var last: String = lines[-1]
		if last == "":
			lines[-1] = word
		elif last.length() + 1 + word.length() <= p_width:
			lines[-1] = last + " " + word
		else:
			lines.append(word)
	return lines


static func _cell(p_text: String) -> String:
	return "`%s`" % p_text.replace("|", "\\|") if p_text != "" else ""
