class_name LoginRateLimiter
extends RefCounted
## How often passwords may be tried where connections are not sealed, as [code]PasswordTries[/code]
## of the sealed ones: a try is charged when it begins and given back by success alone.
##
## It is charged to its address (IPv6: its /64), to the addresses around it (IPv4: /24, IPv6: /48),
## and to all. Those of whom no try has failed lately share a budget of their own: guessers use up
## that of the others, and keep no newcomer out for long.

## Tries of an address at once.
const BURST: int = 5
## Seconds after which one more is allowed.
const PER_GUESS_S: float = 2.0
## Time after which a try that was not given back is forgotten, s.
const REMEMBERED_S: float = 3600.0
## Networks whose failures are remembered; the oldest go.
const MAX_NETWORKS: int = 4096

var _of_network: Allowance = Allowance.new(BURST, 1.0 / PER_GUESS_S)
var _around: Allowance = Allowance.new(8.0, 1.2)
var _newcomers: Allowance = Allowance.new(16.0, 6.0)
var _others: Allowance = Allowance.new(4.0, 1.5)
## Tries of a network that were not given back, and when the last one was.
var _open: Dictionary[String, int] = {}
var _seen_s: Dictionary[String, float] = {}
var _was_newcomer: bool = false


## Charges a try at a time, s, if each budget has one left.
func take(p_address: String, p_now_s: float) -> bool:
	var network: String = AddressNetwork.of(p_address)
	var around: String = AddressNetwork.around(p_address)
	if p_now_s - _seen_s.get(network, -INF) > REMEMBERED_S:
		_open.erase(network)
	_was_newcomer = _open.get(network, 0) <= 0
	var all: Allowance = _newcomers if _was_newcomer else _others
	var has_left: bool = _of_network.has(network, p_now_s) and _around.has(around, p_now_s)
	if not has_left or not all.take(0, p_now_s):
		return false
	_of_network.take(network, p_now_s)
	_around.take(around, p_now_s)
	if not _seen_s.has(network) and _seen_s.size() >= MAX_NETWORKS:
		_make_room(p_now_s)
	_open[network] = _open.get(network, 0) + 1
	_seen_s[network] = p_now_s
	return true


## The try that was taken last, of this address, was the right password.
func give_back(p_address: String) -> void:
	var network: String = AddressNetwork.of(p_address)
	_of_network.give_back(network)
	_around.give_back(AddressNetwork.around(p_address))
	(_newcomers if _was_newcomer else _others).give_back(0)
	_open[network] = maxi(_open.get(network, 0) - 1, 0)


func _make_room(p_now_s: float) -> void:
	for network: String in _seen_s.keys():
		if _open.get(network, 0) <= 0 or p_now_s - _seen_s[network] > REMEMBERED_S:
			_forget(network)
	if _seen_s.size() >= MAX_NETWORKS:
		_forget(_seen_s.keys()[0])


func _forget(p_network: String) -> void:
	_seen_s.erase(p_network)
	_open.erase(p_network)
