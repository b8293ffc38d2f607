class_name ServerFinder
extends RefCounted
## Looks for servers: asks everybody on this machine's networks, and the addresses that it is given,
## again and again. Nothing here waits; call [method poll] in each frame.
##
## What it finds is not proved: anybody on the network can say that he is a server. The key of a
## server is checked where it is joined ([ServerTrust]).

## Servers have come, changed or gone.
signal changed

## Servers in the list at most, without those that were asked for by the user.
const MAX_FOUND: int = 256
## UDP ports that are tried where no port is known.
const PORTS: PackedInt32Array = [7777, 7778, 7779, 7780]
## This machine.
const HERE: PackedStringArray = ["127.0.0.1", "::1"]

## Seconds before the next questions: more often at the beginning.
const _ROUNDS_S: PackedFloat32Array = [0.25, 0.5, 0.75, 1.5]
## Datagrams taken in by one [method poll]: a flood costs no more than a part of a frame.
const _MAX_TAKEN: int = 96

## Addresses where everybody is to be asked, such as a network's broadcast address.
var networks: PackedStringArray = []
## Addresses that are asked on each of [member ports].
var hosts: PackedStringArray = []
## UDP ports that are tried at [member networks] and [member hosts].
var ports: PackedInt32Array = PORTS
## Why nothing can be looked for, or an empty text.
var error: String = ""

var _port: DiscoveryPort = DiscoveryPort.new()
var _found: Dictionary[String, FoundServer] = {}
var _wanted: Dictionary[String, FoundServer] = {}
var _names: Dictionary[String, HostLookup] = {}
var _round: int = 0
var _ask_at_usec: int = 0
var _is_open: bool = false


## Everybody on this machine's networks, and on this machine. Tests name their own addresses.
static func of_all_networks() -> ServerFinder:
	var made: ServerFinder = ServerFinder.new()
	made.networks = DiscoveryPort.new().get_neighbours()
	made.hosts = HERE
	return made


## Begins to look.
func begin() -> void:
	_is_open = _port.open() == OK
	error = "" if _is_open else "this machine has no network"
	_round = 0
	_ask_at_usec = Time.get_ticks_usec()


## Looks for a server at an address, too, and keeps it in the list though nothing answers.
func want(p_address: ServerAddress) -> void:
	var key: String = FoundServer.key_of(p_address.host, p_address.port)
	if _wanted.has(key):
		return
	var server: FoundServer = _found.get(key, FoundServer.new())
	server.address = p_address
	server.is_wanted = true
	_found.erase(key)
	_wanted[key] = server
	changed.emit()


## Keeps a server in the list no longer than it answers.
func unwant(p_server: FoundServer) -> void:
	if not _wanted.erase(p_server.key()):
		return
	p_server.is_wanted = false
	if p_server.answers():
		_found[p_server.key()] = p_server
	changed.emit()


## Asks where it is time, and takes in what has come.
func poll() -> void:
	if not _is_open:
		return
	var now: int = Time.get_ticks_usec()
	var is_new: bool = _take_answers()
	if now >= _ask_at_usec:
		is_new = _end_round() or is_new
		_ask_all()
		_ask_at_usec = now + int(_ROUNDS_S[mini(_round, _ROUNDS_S.size() - 1)] * 1e6)
		_round += 1
	if is_new:
		changed.emit()


## What is known now, one entry for each server: those that the user asked for first.
func servers() -> Array[FoundServer]:
	var list: Array[FoundServer] = _wanted.values()
	var ranks: Dictionary[String, int] = {}
	for server: FoundServer in list:
		if server.answers():
			ranks[_run_of(server)] = -1
	for server: FoundServer in _found.values():
		ranks[_run_of(server)] = mini(ranks.get(_run_of(server), _rank(server)), _rank(server))
	for server: FoundServer in _found.values():
		if _rank(server) <= ranks[_run_of(server)]:
			list.append(server)
	return list


## Stops looking.
func close() -> void:
	_port.close()
	_is_open = false


## The address of a server as it stands, or what its name was found to be; empty where that is not
## known yet.
func _numeric_of(p_server: FoundServer) -> String:
	var host: String = p_server.address.host
	if p_server.address.is_numeric():
		return host
	if not _names.has(host):
		_names[host] = HostLookup.new(host)
	return _names[host].poll()


func _ask_all() -> void:
	for address: String in networks:
		for port: int in ports:
			_port.ask(address, port, true)
	for address: String in hosts:
		for port: int in ports:
			_port.ask(address, port, false)
	for server: FoundServer in _wanted.values():
		var address: String = _numeric_of(server)
		if address != "":
			_port.ask(address, server.address.port, false)
	# Who was not heard may not have heard: many networks lose what goes to all.
	for server: FoundServer in _found.values():
		if server.missed > 1:
			_port.ask(server.address.host, server.address.port, false)


## A round is over: who has not answered in it? Returns whether somebody is gone.
func _end_round() -> bool:
	var is_new: bool = false
	for server: FoundServer in _wanted.values():
		server.missed += 1
		is_new = is_new or server.missed == FoundServer.MAX_MISSED + 1
	for key: String in _found.keys():
		_found[key].missed += 1
		if _found[key].missed > FoundServer.MAX_MISSED:
			_found.erase(key)
			is_new = true
	return is_new


func _take_answers() -> bool:
	var is_new: bool = false
	for answer: DiscoveryAnswer in _port.take(_MAX_TAKEN):
		var said: ServerAnnouncement = ServerAnnouncement.decode(answer.body)
		if said != null:
			is_new = _take(answer, said) or is_new
	return is_new


func _take(p_answer: DiscoveryAnswer, p_said: ServerAnnouncement) -> bool:
	var delay_s: float = p_answer.delay_usec / 1e6
	var is_new: bool = false
	var key: String = FoundServer.key_of(p_answer.address, p_answer.port)
	for server: FoundServer in _wanted.values():
		if server.key() == key or _is_named(server, p_answer):
			is_new = server.take(p_said, delay_s) or is_new
	if _wanted.has(key):
		return is_new
	if not _found.has(key):
		if not _make_room():
			return is_new
		var server: FoundServer = FoundServer.new()
		server.address.host = p_answer.address
		server.address.port = p_answer.port
		_found[key] = server
	return _found[key].take(p_said, delay_s) or is_new


func _is_named(p_server: FoundServer, p_answer: DiscoveryAnswer) -> bool:
	if p_server.address.is_numeric() or p_server.address.port != p_answer.port:
		return false
	return _numeric_of(p_server) == p_answer.address


## Who answers keeps the place; who does not makes room. Returns whether there is any.
func _make_room() -> bool:
	if _found.size() < MAX_FOUND:
		return true
	for key: String in _found:
		# In the present round most have not answered yet.
		if _found[key].missed > 1:
			_found.erase(key)
			return true
	Log.limited("net", "servers", "more than %d servers answer: no more are shown" % MAX_FOUND)
	return false


## What is the same at all addresses of a server.
static func _run_of(p_server: FoundServer) -> String:
	return "%d %d" % [p_server.announcement.run, p_server.address.port]


## How good an address of a server is, as a machine has several: nobody from elsewhere can answer
## for this machine, and an IPv6 address of a link is good on that link only. Of two addresses that
## are as good neither is left out, so that nobody hides a server by answering for it.
static func _rank(p_server: FoundServer) -> int:
	var host: String = p_server.address.host
	if host.begins_with("127.") or host == "::1":
		return 0 if host == "127.0.0.1" else 1
	if host.begins_with("fe80:"):
		return 4
	return 3 if host.contains(":") else 2
