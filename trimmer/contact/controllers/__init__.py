"""The laws of controllers, as exact motion needs them."""
