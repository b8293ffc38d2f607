"""All sounds of Dismount, made from their physics: no recording is needed or used."""
