class_name WaitingLine
extends RefCounted
## Those who wait at a server, for an instructor or for room, in the order in which they came.
##
## It is bounded, for each address and in all. Where it is full, the last peer of the address with
## most peers makes room for one of an address with fewer: an attacker who fills it pushes out
## nobody else.

## Clients that may wait.
const MAX: int = 64

var _waiting: Array[PendingPeer] = []


## Those who wait.
func all() -> Array[PendingPeer]:
	return _waiting


## Puts somebody at its end. Returns false if he may not wait; [param r_pushed] gets who must not
## wait any longer.
func add(p_pending: PendingPeer, p_most_of_address: int, r_pushed: Array[PendingPeer]) -> bool:
	var of_network: Dictionary[String, int] = {}
	var of_site: int = 0
	for other: PendingPeer in _waiting:
		of_network[other.network] = of_network.get(other.network, 0) + 1
		of_site += 1 if other.site == p_pending.site else 0
	var mine: int = of_network.get(p_pending.network, 0)
	var most: int = p_most_of_address
	if most > 0 and (mine >= most or of_site >= ServerRules.SITE_SHARES * most):
		return false
	if _waiting.size() >= MAX:
		var last: PendingPeer = _last_of_largest(of_network, mine + 1)
		if last == null:
			return false
		remove(last)
		r_pushed.append(last)
	p_pending.waits = true
	_waiting.append(p_pending)
	return true


## Somebody waits for something else from now on, at the end.
func move_back(p_pending: PendingPeer) -> void:
	_waiting.erase(p_pending)
	_waiting.append(p_pending)


## Somebody waits no longer.
func remove(p_pending: PendingPeer) -> void:
	p_pending.waits = false
	_waiting.erase(p_pending)


## The positions of all, from 1: those who wait for an instructor are one line, all others another.
func places() -> Dictionary[PendingPeer, int]:
	var made: Dictionary[PendingPeer, int] = {}
	var for_instructor: int = 0
	for index: int in _waiting.size():
		var is_first_kind: bool = _waiting[index].waits_for == JoinReply.Wait.INSTRUCTOR
		for_instructor += 1 if is_first_kind else 0
		made[_waiting[index]] = for_instructor if is_first_kind else index + 1 - for_instructor
	return made


## The last of the address that has most here, if that has more than so many.
func _last_of_largest(p_of_network: Dictionary[String, int], p_more_than: int) -> PendingPeer:
	var largest: String = ""
	for network: String in p_of_network:
		if p_of_network[network] > p_of_network.get(largest, p_more_than):
			largest = network
	for index: int in range(_waiting.size() - 1, -1, -1):
		if _waiting[index].network == largest:
			return _waiting[index]
	return null
