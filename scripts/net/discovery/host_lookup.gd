class_name HostLookup
extends RefCounted
## Looks the address of a name up without waiting for it.

## Seconds until a name that was not found is looked up again.
const _AGAIN_S: float = 10.0

var _host: String = ""
var _number: int = IP.RESOLVER_INVALID_ID
var _address: String = ""
var _again_usec: int = 0


func _init(p_host: String) -> void:
	_host = p_host


func _notification(p_what: int) -> void:
	if p_what == NOTIFICATION_PREDELETE and _number != IP.RESOLVER_INVALID_ID:
		IP.erase_resolve_item(_number)


## The address; empty as long as it is not known.
func poll() -> String:
	if _address != "":
		return _address
	if _number == IP.RESOLVER_INVALID_ID:
		if Time.get_ticks_usec() >= _again_usec:
			# Whatever there is: a name may have an IPv6 address only.
			_number = IP.resolve_hostname_queue_item(_host, IP.TYPE_ANY)
		return ""
	var status: IP.ResolverStatus = IP.get_resolve_item_status(_number)
	if status == IP.RESOLVER_STATUS_WAITING:
		return ""
	if status == IP.RESOLVER_STATUS_DONE:
		_address = IP.get_resolve_item_address(_number)
	IP.erase_resolve_item(_number)
	_number = IP.RESOLVER_INVALID_ID
	_again_usec = Time.get_ticks_usec() + int(_AGAIN_S * 1e6)
	return _address
