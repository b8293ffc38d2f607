class_name TransportSecurity
extends RefCounted
## Whether the connection is encrypted, by DTLS: Debian's build of the engine has none.

## For ENet; null if the connection is not encrypted.
var tls: TLSOptions = null
## Why it cannot be encrypted as requested, or an empty text.
var error: String = ""


## For a server with a certificate and its key; neither for no encryption.
static func server(p_certificate: String, p_key: String) -> TransportSecurity:
	var made: TransportSecurity = TransportSecurity.new()
	if p_certificate == "" and p_key == "":
		return made
	if p_certificate == "" or p_key == "":
		made.error = "encryption needs both --dtls-certificate and --dtls-key"
		return made
	var certificate: X509Certificate = made._load_certificate(p_certificate)
	var key: CryptoKey = CryptoKey.new()
	if made.error == "" and (not FileAccess.file_exists(p_key) or key.load(p_key) != OK):
		made.error = "%s holds no private key (PEM)" % p_key
	if made.error == "":
		made.tls = TLSOptions.server(key, certificate)
		made._check_engine()
	return made


## For a client, which may trust a certificate of its own.
static func client(p_wanted: bool, p_certificate: String) -> TransportSecurity:
	var made: TransportSecurity = TransportSecurity.new()
	if not p_wanted:
		if p_certificate != "":
			made.error = "--dtls-certificate is of no use to a client without --dtls=1"
		return made
	if p_certificate == "":
		made.tls = TLSOptions.client()
	else:
		var trusted: X509Certificate = made._load_certificate(p_certificate)
		# A certificate that was given is trusted whatever its name.
		made.tls = TLSOptions.client_unsafe(trusted) if made.error == "" else null
	if made.error == "":
		made._check_engine()
	return made


## A line for the log.
func describe() -> String:
	if tls != null:
		return "the connection is encrypted (DTLS)"
	return "the connection is not encrypted: use a trusted network or a VPN"


func _load_certificate(p_path: String) -> X509Certificate:
	var certificate: X509Certificate = X509Certificate.new()
	if not FileAccess.file_exists(p_path) or certificate.load(p_path) != OK:
		error = "%s holds no certificate (PEM)" % p_path
	return certificate


## Asks a host, which is useless afterwards, whether the engine has DTLS.
func _check_engine() -> void:
	var host: ENetConnection = ENetConnection.new()
	if host.create_host_bound("127.0.0.1", 0, 1) != OK:
		return
	var outcome: Error = OK
	if tls.is_server():
		outcome = host.dtls_server_setup(tls)
	else:
		outcome = host.dtls_client_setup("127.0.0.1", tls)
	host.destroy()
	if outcome == ERR_UNAVAILABLE:
		tls = null
		error = "this build of the engine has no DTLS: use an official one, or a VPN"
