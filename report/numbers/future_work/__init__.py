"""Numbers of the answers to what section 6.4 of the thesis asks for; what is dear is kept with the code."""
