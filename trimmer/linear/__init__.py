"""The linear model: poles, zeros, responses, resonances, and what follows from them."""
