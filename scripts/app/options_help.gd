class_name OptionsHelp
extends RefCounted
## The rows of [ProgramOptions] and [ProgramRoles] as texts: for the terminal, and docs/options.md.

## Path of the document, and the command that renews it.
const DOCUMENT: String = "res://docs/options.md"
const RENEW: String = "./run options-doc"

const _COLUMN: int = 34
const _INTRODUCTION: Array[String] = [
	"# Options\n\n",
	"Made by `%s` from the rows in `scripts/app/program_options.gd`; `./test lint` fails where",
	" they differ.\n\nOptions are given as `--name=value` or `--name value`, or by the environment:",
	" `DISMOUNT_MAX_CLIENTS=8` is `--max-clients=8`. Arguments win. A role refuses an option that",
	" it does not take; in the environment, which several roles share, it passes over it. Relative",
	" files count from where you started the program. `./run ROLE --help` lists what a role takes.",
	" The other commands of `./run` have options of their own: `./run --help`.\n\n",
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
	return "".join(_INTRODUCTION) % RENEW + "\n".join(lines) + "\n"


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
	return "  %s %s%s" % [p_row.usage().rpad(_COLUMN - 3), p_row.meaning, note]


static func _cell(p_text: String) -> String:
	return "`%s`" % p_text.replace("|", "\\|") if p_text != "" else ""
